using System;
using System.IO;
using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>Account of a <see cref="SceneWitness"/> of the scene that it played, a file beside its pictures.</summary>
    [Serializable]
    internal sealed class SceneAccount
    {
        /// <summary>Frames that were played, and their mean time, ms.</summary>
        public int frames;
        public float milliseconds;

        /// <summary>Errors, exceptions and failed assertions in the log, and the first of them.</summary>
        public int errors;
        public string firstError = "";

        /// <summary>Pictures that were taken, and those of one colour, which show nothing.</summary>
        public int pictures, blank;

        /// <summary>Reads an account.</summary>
        /// <returns>Null where there is none.</returns>
        public static SceneAccount Read(string folder, string scene)
        {
            string path = PathOf(folder, scene);
            return File.Exists(path) ? JsonUtility.FromJson<SceneAccount>(File.ReadAllText(path)) : null;
        }

        /// <summary>Writes it.</summary>
        public void Write(string folder, string scene) => File.WriteAllText(PathOf(folder, scene), JsonUtility.ToJson(this, true));

        private static string PathOf(string folder, string scene) => Path.Combine(folder, scene + ".account.json");
    }
}
