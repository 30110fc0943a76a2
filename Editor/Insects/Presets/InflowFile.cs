using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Reads the air of a wake, as the command <c>wake</c> writes it, into a preset.</summary>
    internal static class InflowFile
    {
        private const int k_Version = 1;
        private const string k_Right = "right ";

        /// <summary>Most bytes of a file.</summary>
        private const long k_Largest = 1 << 20;

        /// <summary>Most wings of an insect, and letters of a wing's name.</summary>
        private const int k_MostWings = 8, k_LongestName = 60;

        /// <summary>
        /// Puts the inflow of a wing into a preset; one step of undo. Of the kinds of wing in the file it is the only one, or the one that
        /// the preset is named after.
        /// </summary>
        /// <returns>Null, or one sentence that says why nothing was changed.</returns>
        public static string Read(WingPreset preset, string path)
        {
            try
            {
                if (new FileInfo(path).Length > k_Largest)
                    return $"'{Path.GetFileName(path)}' is larger than any inflow.";
                Content content = JsonUtility.FromJson<Content>(File.ReadAllText(path));
                string refusal = Find(content, preset.name, Path.GetFileName(path), out PresetInflow inflow);
                if (refusal == null)
                    Edits.Change(preset, "Read Inflow", target => target.Inflow = inflow);
                return refusal;
            }
            catch (Exception failed) when (failed is IOException || failed is UnauthorizedAccessException || failed is ArgumentException)
            {
                return failed.Message;
            }
        }

        private static string Find(Content content, string preset, string file, out PresetInflow inflow)
        {
            inflow = default;
            Entry[] wings = content?.wings ?? Array.Empty<Entry>();
            if (content?.version != k_Version || wings.Length == 0 || wings.Length > k_MostWings || wings.Any(entry => !IsNamed(entry)))
                return $"'{file}' is no inflow of version {k_Version}, as the command wake writes it.";
            var right = wings.Where(entry => entry.wing.StartsWith(k_Right, StringComparison.Ordinal)).ToList();
            List<Entry> named = right.Count == 1 ? right : right.Where(entry => IsNamedAfter(preset, entry)).ToList();
            if (named.Count != 1)
            {
                return $"'{file}' holds {string.Join(" and ", wings.Select(entry => entry.wing))}; "
                    + $"rename the preset '{preset}' after the wing that it is for, as in 'Dragonfly hind wing'.";
            }
            return TryRead(named[0], out inflow)
                ? null
                : $"'{file}' has a number of the {named[0].wing} that is missing or not within ±{PresetInflow.MostSpeed:0} m/s.";
        }

        private static bool IsNamed(Entry entry) => entry?.wing != null && entry.wing.Length <= k_LongestName;

        private static bool IsNamedAfter(string preset, Entry entry) =>
            preset.IndexOf(entry.wing.Substring(k_Right.Length), StringComparison.OrdinalIgnoreCase) >= 0;

        private static bool TryRead(Entry entry, out PresetInflow inflow)
        {
            inflow = default;
            return TryRead(entry.mean_m_s, out inflow.mean) && TryRead(entry.cosine_1_m_s, out inflow.cosine1)
                && TryRead(entry.sine_1_m_s, out inflow.sine1) && TryRead(entry.cosine_2_m_s, out inflow.cosine2)
                && TryRead(entry.sine_2_m_s, out inflow.sine2);
        }

        private static bool TryRead(float[] axes, out Vector3 vector)
        {
            bool holds = axes != null && axes.Length == 3 && axes.All(speed => math.abs(speed) <= PresetInflow.MostSpeed);
            vector = holds ? new Vector3(axes[0], axes[1], axes[2]) : default;
            return holds;
        }

        /// <summary>The file; fields have the names of its keys.</summary>
        [Serializable]
        private sealed class Content
        {
            public int version = -1;
            public Entry[] wings = Array.Empty<Entry>();
        }

        [Serializable]
        private sealed class Entry
        {
            public string wing = "";
            public float[] mean_m_s = s_None, cosine_1_m_s = s_None, sine_1_m_s = s_None, cosine_2_m_s = s_None, sine_2_m_s = s_None;

            private static readonly float[] s_None = Array.Empty<float>();
        }
    }
}
