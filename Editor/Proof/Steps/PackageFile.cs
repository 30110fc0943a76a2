using System;
using System.IO;
using UnityEngine;

namespace Alate.Proof
{
    /// <summary>Facts that a package.json holds.</summary>
    [Serializable]
    internal sealed class PackageFile
    {
        /// <summary>Version of the package.</summary>
        public string version = "";

        /// <summary>Version of the package in a folder; null where there is none.</summary>
        public static string VersionIn(string folder)
        {
            string path = Path.Combine(folder, "package.json");
            return File.Exists(path) ? JsonUtility.FromJson<PackageFile>(File.ReadAllText(path)).version : null;
        }
    }
}
