using System;
using System.Globalization;
using System.Text;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>Skeletons as JSON text, to carry them between tools.</summary>
    /// <remarks>
    /// <c>{"version":1,"hinge":[x,y,z],"span":[x,y,z],"up":[x,y,z],"chains":[[[x,y,z],…],…]}</c>: chains from leading to trailing
    /// edge, joints from root to tip, positions in mesh space. These keys are required, in any order. Where the stiffness of a chain is
    /// measured there are <c>"flexuralStiffness":[[EI,…],…]</c> and <c>"torsionalStiffness":[[GJ,…],…]</c>, a list for each chain, N·m²;
    /// where veins are known <c>"veinWidths":[[width,…],…]</c>; there are no other keys.
    /// </remarks>
    [MovedFrom(true, "Alate", "Alate")]
    public static class SkeletonJson
    {
        internal const string k_Version = "version";
        internal const string k_Hinge = "hinge";
        internal const string k_Span = "span";
        internal const string k_Up = "up";
        internal const string k_Chains = "chains";
        internal const string k_Flexural = "flexuralStiffness";
        internal const string k_Torsional = "torsionalStiffness";
        internal const string k_Widths = "veinWidths";

        /// <summary>The skeleton as text, one chain a line; reading it gives the same numbers to the last bit.</summary>
        /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
        /// <exception cref="ArgumentException">A number is not finite, which JSON cannot say.</exception>
        public static string Write(WingSkeleton skeleton) => Write(skeleton, default);

        /// <summary>The JSON text of a skeleton whose positions are counted from a place of the space that the text is in.</summary>
        internal static string Write(WingSkeleton skeleton, (double x, double y, double z) origin)
        {
            if (skeleton == null)
                throw new ArgumentNullException(nameof(skeleton));
            var text = new StringBuilder();
            text.Append("{\n  \"").Append(k_Version).Append("\": ").Append(WingSkeleton.CurrentVersion);
            AppendMember(text, k_Hinge, skeleton.Hinge, origin);
            AppendMember(text, k_Span, skeleton.SpanAxis, default);
            AppendMember(text, k_Up, skeleton.UpAxis, default);
            AppendKey(text, k_Chains).Append('[');
            JointChain[] chains = skeleton.Chains;
            for (int i = 0; i < chains.Length; i++)
            {
                text.Append(i == 0 ? "\n    [" : ",\n    [");
                for (int j = 0; j < chains[i].Length; j++)
                    Append(j == 0 ? text : text.Append(", "), chains[i].joints[j], origin);
                text.Append(']');
            }

            text.Append("\n  ]");
            AppendValues(text, k_Flexural, Array.ConvertAll(chains, chain => chain.flexuralStiffness));
            AppendValues(text, k_Torsional, Array.ConvertAll(chains, chain => chain.torsionalStiffness));
            AppendValues(text, k_Widths, Array.ConvertAll(chains, chain => chain.veinWidths));
            return text.Append("\n}\n").ToString();
        }

        /// <summary>Reads the skeleton that a text describes. <see cref="WingSkeleton.Validate"/> tells whether it is usable.</summary>
        /// <exception cref="ArgumentNullException">There is no text.</exception>
        /// <exception cref="FormatException">The text is not such a skeleton; the message says where and why, in one line.</exception>
        public static WingSkeleton Read(string json) => Read(json, default);

        /// <summary>The skeleton that a text describes, its positions counted from a place of the text's space.</summary>
        internal static WingSkeleton Read(string json, (double x, double y, double z) origin)
        {
            if (json == null)
                throw new ArgumentNullException(nameof(json));
            SkeletonJsonReader.Content content = new SkeletonJsonReader(json, origin).Read();
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Hinge = content.hinge;
            skeleton.SpanAxis = content.span;
            skeleton.UpAxis = content.up;
            skeleton.Chains = content.chains;
            return skeleton;
        }

        // A list for each chain; nothing where no chain has values.
        private static void AppendValues(StringBuilder text, string key, float[][] values)
        {
            if (!Array.Exists(values, ChainValues.AreGiven))
                return;
            AppendKey(text, key).Append('[');
            for (int i = 0; i < values.Length; i++)
            {
                text.Append(i == 0 ? "[" : ", [");
                for (int k = 0; values[i] != null && k < values[i].Length; k++)
                    text.Append(k == 0 ? "" : ", ").Append(Number(Finite(values[i][k]), 0.0));
                text.Append(']');
            }

            text.Append(']');
        }

        private static void AppendMember(StringBuilder text, string key, Vector3 value, (double x, double y, double z) origin) =>
            Append(AppendKey(text, key), value, origin);

        private static StringBuilder AppendKey(StringBuilder text, string key) => text.Append(",\n  \"").Append(key).Append("\": ");

        private static void Append(StringBuilder text, Vector3 v, (double x, double y, double z) origin)
        {
            text.Append('[').Append(Number(Finite(v.x), origin.x)).Append(", ").Append(Number(Finite(v.y), origin.y)).Append(", ")
                .Append(Number(Finite(v.z), origin.z)).Append(']');
        }

        private static float Finite(float value) =>
            math.isfinite(value)
            ? value
            : throw new ArgumentException("A skeleton with a number that is not finite cannot be written as JSON.");

        // The shortest of the two formats that comes back as the same number.
        private static string Number(float value, double origin)
        {
            if (origin != 0.0)
                return (origin + value).ToString("R", CultureInfo.InvariantCulture);
            string shortest = value.ToString("R", CultureInfo.InvariantCulture);
            return float.Parse(shortest, CultureInfo.InvariantCulture) == value
                ? shortest
                : value.ToString("G9", CultureInfo.InvariantCulture);
        }
    }
}
