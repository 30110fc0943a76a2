using System;
using Alate.Authoring;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Takes over a skeleton from its text.</summary>
    internal static class ImportCommand
    {
        /// <summary>What a text of <see cref="SkeletonJson"/> describes; one line that says where and why where it describes nothing.</summary>
        public static Proposal Make(string json)
        {
            WingSkeleton read = null;
            try
            {
                read = SkeletonJson.Read(json);
                string fault = SkeletonDraft.Read(read, out SkeletonDraft draft);
                return fault == null ? Proposal.Make(draft, Array.Empty<JointIndex>()) : Proposal.Refuse(fault);
            }
            catch (FormatException refused)
            {
                return Proposal.Refuse(refused.Message);
            }
            finally
            {
                if (read != null)
                    Object.DestroyImmediate(read);
            }
        }
    }
}
