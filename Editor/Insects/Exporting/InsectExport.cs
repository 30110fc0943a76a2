using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Files;
using Alate.Flight;

namespace Alate.Editor
{
    /// <summary>
    /// Writes an insect of a scene as an insect file: the numbers of its presets, and meshes, skeletons and pictures of its wings beside
    /// it.
    /// </summary>
    internal static class InsectExport
    {
        private const int k_LongestName = 40;

        /// <summary>Writes the file, over what is there.</summary>
        /// <param name="insect">The insect.</param>
        /// <param name="path">Path of the file.</param>
        /// <returns>Null, or one sentence that says why not all was written.</returns>
        public static string Write(InsectWings insect, string path)
        {
            try
            {
                List<ExportedWing> kinds = ExportedWing.Of(insect);
                InsectDefinition like = InsectCatalogue.Find(kinds.Count == 1 ? "monarch" : "dragonfly");
                string name = NameOf(path), folder = Path.GetDirectoryName(path) ?? "";
                var wings = new JsonMembers();
                foreach (ExportedWing kind in kinds)
                    wings.Add(kind.Name, kind.Write(folder, $"{name}-{kind.Name.Replace(' ', '-')}"));
                var said = new JsonMembers();
                said.Add(InsectKeys.Like, FileValue.Of(like.Name));
                said.Add(InsectKeys.Wings, wings.ToPlace());
                var defined = new List<WingDefinition>();
                float metresPerUnit = kinds[0].MetresPerUnit;
                for (int k = 0; k < kinds.Count; k++)
                    defined.Add(kinds[k].Define(like.Wings[k], metresPerUnit));
                var written = new InsectDefinition(name, insect.name, defined, like.Body, Array.Empty<InsectSource>())
                {
                    FlightParts = Parts(insect, like, kinds[0].Length),
                    FileText = JsonText.Write(said.ToPlace()),
                };
                File.WriteAllText(path, InsectFileText.Write(written));
                return null;
            }
            catch (Exception failed) when (failed is UserException || failed is IOException || failed is UnauthorizedAccessException)
            {
                return failed.Message;
            }
        }

        // Those by which it flies, or those of the catalogue's in its size.
        private static IReadOnlyList<BodyEllipsoid> Parts(InsectWings insect, InsectDefinition like, float length)
        {
            if (insect.TryGetComponent(out InsectFlight flight) && flight.Parts.Count > 0)
                return flight.Parts.ToArray();
            float scale = length / like.Wings[0].PresetLength();
            return like.FlightParts.Select(part => part.Scaled(scale)).ToArray();
        }

        // "My Moth.insect.json" is "my-moth".
        private static string NameOf(string path)
        {
            string name = Path.GetFileName(path);
            int end = name.IndexOf('.');
            name = Regex.Replace((end < 0 ? name : name.Substring(0, end)).ToLowerInvariant(), "[^a-z0-9]+", "-").Trim('-');
            if (name.Length == 0 || !char.IsLetter(name[0]))
                name = "insect-" + name;
            return name.Substring(0, Math.Min(name.Length, k_LongestName)).Trim('-');
        }
    }
}
