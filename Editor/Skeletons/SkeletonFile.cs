using System;
using System.IO;
using Alate.Authoring;

namespace Alate.Editor
{
    /// <summary>Reads a skeleton from a JSON file into an asset, undoably, and writes it to one.</summary>
    internal static class SkeletonFile
    {
        /// <summary>Replaces a skeleton by what a file holds; one step of undo.</summary>
        /// <returns>Null, or one sentence that says why nothing was changed.</returns>
        public static string Read(WingSkeleton skeleton, string path, IUndoRecorder undo) => Try(() =>
        {
            var editing = new SkeletonEditing(JointSelection.Of(skeleton), undo) { Lock = SkeletonSessions.LockOf(skeleton) };
            editing.Start(out EditStart start);
            return editing.Commit("Import Skeleton", start, ImportCommand.Make(File.ReadAllText(path))).Message;
        });

        /// <summary>Writes a skeleton, over what the file holds.</summary>
        /// <returns>Null, or one sentence that says why nothing was written.</returns>
        public static string Write(WingSkeleton skeleton, string path) => Try(() =>
        {
            File.WriteAllText(path, SkeletonJson.Write(skeleton));
            return null;
        });

        private static string Try(Func<string> action)
        {
            try
            {
                return action();
            }
            catch (Exception failed) when (failed is IOException || failed is UnauthorizedAccessException || failed is ArgumentException)
            {
                return failed.Message;
            }
        }
    }
}
