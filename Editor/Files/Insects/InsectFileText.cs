using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>Writes an insect as an insect file that says all of its numbers.</summary>
    internal static class InsectFileText
    {
        /// <summary>
        /// The file of an insect of the catalogue, or of another file with all that this has from elsewhere; paths are as the file has
        /// them.
        /// </summary>
        public static string Write(InsectDefinition insect)
        {
            JsonPlace said = insect.FileText == null ? null : JsonReader.Read(insect.FileText);
            WingPreset[] standard = Presets(insect, InsectVariant.Standard);
            var file = new JsonMembers();
            file.Add(InsectKeys.VersionKey, FileValue.Of((decimal)InsectKeys.Version));
            file.Add(InsectKeys.Name, FileValue.Of(insect.Name));
            file.Add(InsectKeys.DisplayName, FileValue.Of(insect.DisplayName));
            file.Add(InsectKeys.Like, said?[InsectKeys.Like] ?? FileValue.Of(insect.Name));
            JsonMembers[] wings = Numbers(standard, null, file);
            for (int k = 0; k < wings.Length; k++)
            {
                wings[k].Add(InsectKeys.Hinge, FileValue.Of(insect.Wings[k].Hinge));
                wings[k].Copy(said?[InsectKeys.Wings]?[insect.Wings[k].Name], InsectKeys.Mesh, InsectKeys.Skeleton, InsectKeys.Texture,
                    InsectKeys.Flexural, InsectKeys.Torsional, InsectKeys.VeinWidths);
            }

            file.Add(InsectKeys.Wings, Named(insect, wings));
            var body = new JsonMembers();
            body.Add(InsectKeys.Parts, FileValue.List(insect.FlightParts.Select(Part)));
            body.Copy(said?[InsectKeys.Body], InsectKeys.Scale, InsectKeys.Mesh, InsectKeys.MeshUnit);
            file.Add(InsectKeys.Body, body.ToPlace());
            file.Copy(said, InsectKeys.Kinematics, InsectKeys.Trims);
            file.Add(InsectKeys.Sources, FileValue.List(insect.Sources.Select(Source)));
            file.Add(InsectKeys.Variants, Variants(insect, standard));
            Destroy(standard);
            return JsonText.Write(file.ToPlace());
        }

        // Only what differs from the standard one.
        private static JsonPlace Variants(InsectDefinition insect, WingPreset[] standard)
        {
            var variants = new JsonMembers();
            foreach (InsectVariant variant in insect.Variants.Skip(1))
            {
                WingPreset[] presets = Presets(insect, variant);
                var numbers = new JsonMembers();
                JsonMembers[] wings = Numbers(presets, standard, numbers);
                if (wings.Any(wing => wing.Count > 0))
                    numbers.Add(InsectKeys.Wings, Named(insect, wings));
                variants.Add(InsectKeys.Word(variant), numbers.ToPlace());
                Destroy(presets);
            }

            return variants.ToPlace();
        }

        // Numbers that all wings have in common stand once; where there is a standard, only those that differ from it.
        private static JsonMembers[] Numbers(WingPreset[] presets, WingPreset[] standard, JsonMembers file)
        {
            JsonMembers[] wings = presets.Select(_ => new JsonMembers()).ToArray();
            foreach (PresetKey key in InsectKeys.OfInsect)
                Add(key, presets, standard, file, null);
            foreach (PresetKey key in InsectKeys.OfWing)
                Add(key, presets, standard, null, wings);
            foreach ((string name, _, IReadOnlyList<PresetKey> keys) in InsectKeys.Groups)
            {
                var common = new JsonMembers();
                JsonMembers[] own = presets.Select(_ => new JsonMembers()).ToArray();
                foreach (PresetKey key in keys)
                    Add(key, presets, standard, common, own);
                if (common.Count > 0)
                    file.Add(name, common.ToPlace());
                for (int k = 0; k < own.Length; k++)
                {
                    if (own[k].Count > 0)
                        wings[k].Add(name, own[k].ToPlace());
                }
            }

            return wings;
        }

        private static void Add(PresetKey key, WingPreset[] presets, WingPreset[] standard, JsonMembers common, JsonMembers[] own)
        {
            JsonPlace[] values = presets.Select(preset => FileValue.Of(key.Of(preset))).ToArray();
            IEnumerable<string> lines = values.Select(JsonText.Line);
            if (standard != null && lines.SequenceEqual(standard.Select(preset => JsonText.Line(FileValue.Of(key.Of(preset))))))
                return;
            if (own == null || common != null && lines.Distinct().Count() == 1)
            {
                common.Add(key.Name, values[0]);
                return;
            }

            for (int k = 0; k < values.Length; k++)
                own[k].Add(key.Name, values[k]);
        }

        private static JsonPlace Named(InsectDefinition insect, JsonMembers[] wings)
        {
            var named = new JsonMembers();
            for (int k = 0; k < wings.Length; k++)
                named.Add(insect.Wings[k].Name, wings[k].ToPlace());
            return named.ToPlace();
        }

        private static WingPreset[] Presets(InsectDefinition insect, InsectVariant variant) =>
            insect.Wings.Select(wing => wing.CreatePreset(ModelReading.Physical, variant)).ToArray();

        private static void Destroy(WingPreset[] presets)
        {
            foreach (WingPreset preset in presets)
                Object.DestroyImmediate(preset);
        }

        private static JsonPlace Part(BodyEllipsoid part)
        {
            var said = new JsonMembers();
            said.Add(InsectKeys.Centre, FileValue.Of(part.centre));
            said.Add(InsectKeys.HalfAxes, FileValue.Of(part.halfAxes));
            said.Add(InsectKeys.MassShare, FileValue.Number(part.share, 1m));
            if (part.swing != 0f)
            {
                said.Add(InsectKeys.Swing, FileValue.Number(part.swing, 1m));
                said.Add(InsectKeys.Lowest, FileValue.Number(part.lowestPhase, 1m));
            }

            return said.ToPlace();
        }

        private static JsonPlace Source(InsectSource source)
        {
            var said = new JsonMembers();
            said.Add(InsectKeys.Quantity, FileValue.Of(source.Quantity));
            said.Add(InsectKeys.Value, FileValue.Of(source.Value));
            said.Add(InsectKeys.Source, FileValue.Of(source.Source));
            if (source.Variant != InsectVariant.Standard)
                said.Add(InsectKeys.Variant, FileValue.Of(InsectKeys.Word(source.Variant)));
            return said.ToPlace();
        }
    }
}
