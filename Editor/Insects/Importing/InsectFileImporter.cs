using System;
using System.Collections.Generic;
using System.IO;
using Alate.Files;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Imports insect files, <c>NAME.insect.json</c>, as prefabs with all their parts. An insect is imported again when its file, or one
    /// that it names, changes.
    /// </summary>
    [ScriptedImporter(k_Version, k_Ending, k_Last)]
    internal sealed class InsectFileImporter : ScriptedImporter
    {
        private const int k_Version = 1;

        // Behind the shaders and pictures.
        private const int k_Last = 1000;
        private const string k_Ending = "insect.json";

        [SerializeField, Tooltip("The prefab flies about by its own wings; otherwise it beats on the spot.")]
        private bool m_Flies;

        /// <summary>Returns true where the prefab flies about by its own wings.</summary>
        internal bool Flies
        {
            get => m_Flies;
            set => m_Flies = value;
        }

        /// <summary>Reads and imports the file; what is wrong with it is an error of the import with file, line and key.</summary>
        public override void OnImportAsset(AssetImportContext ctx)
        {
            var files = new DiskFiles(path => FileUtil.GetPhysicalPath(Plain(path)));
            try
            {
                ImportedInsect.Add(ctx, InsectFile.Read(ctx.assetPath, files), m_Flies);
            }
            catch (Exception problem) when (problem is UserException || problem is InvalidOperationException)
            {
                ctx.LogImportError(problem.Message);
            }

            foreach (string path in files.Paths)
            {
                string asset = Plain(path);
                if (asset != ctx.assetPath && !Path.IsPathRooted(asset))
                    ctx.DependsOnSourceAsset(asset);
            }
        }

        // "Assets/Moth/../Wings/fore.obj" is "Assets/Wings/fore.obj".
        private static string Plain(string path)
        {
            var folders = new List<string>();
            foreach (string name in path.Replace(Path.DirectorySeparatorChar, '/').Split('/'))
            {
                if (name == ".." && folders.Count > 0)
                    folders.RemoveAt(folders.Count - 1);
                else if (name != ".")
                    folders.Add(name);
            }

            return string.Join("/", folders);
        }
    }
}
