using System;
using Alate.Authoring;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Replaces a skeleton by one read from text.</summary>
    internal static class ImportCommand
    {
        /// <summary>Reads a text of <see cref="SkeletonJson"/>; refuses with one line that gives place and reason.</summary>
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
