using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>Lines and pictures of one step in one render pipeline, as its editor leaves them in a file.</summary>
    [Serializable]
    internal sealed class ProofPart
    {
        /// <summary>Step, as in <see cref="ProofStep.Name"/>.</summary>
        public string step = "";

        /// <summary>Render pipeline: builtin, urp or hdrp.</summary>
        public string pipeline = "";

        /// <summary>Editor and machine that made it; empty where no editor did.</summary>
        public string editor = "", machine = "";

        /// <summary>Lines in the order of the report.</summary>
        public List<ProofLine> lines = new List<ProofLine>();

        /// <summary>Pictures, paths from the report's folder with '/'.</summary>
        public List<string> pictures = new List<string>();

        /// <summary>Path of the file of a step, from the report's folder.</summary>
        public static string PathOf(string folder, string pipeline, string step) => Path.Combine(folder, pipeline, step + ".json");

        /// <summary>Reads what a step left.</summary>
        /// <returns>Null where there is no such file, or none that can be read.</returns>
        public static ProofPart Read(string path)
        {
            if (!File.Exists(path))
                return null;
            try
            {
                return JsonUtility.FromJson<ProofPart>(File.ReadAllText(path));
            }
            catch (ArgumentException)
            {
                return null;
            }
        }

        /// <summary>Writes the file of its step, all of it or nothing.</summary>
        public void Write(string folder)
        {
            string path = PathOf(folder, pipeline, step);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path + ".part", JsonUtility.ToJson(this, true));
            if (File.Exists(path))
                File.Delete(path);
            File.Move(path + ".part", path);
        }
    }
}
