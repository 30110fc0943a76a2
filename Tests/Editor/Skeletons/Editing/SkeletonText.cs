using System;
using System.Text;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>All serialised values of a skeleton as text, numbers by their bits, so that equal texts are identical assets.</summary>
    internal static class SkeletonText
    {
        public static string Of(WingSkeleton skeleton)
        {
            var text = new StringBuilder();
            text.Append(skeleton.name).Append(' ').Append(skeleton.Version);
            Append(text, skeleton.Hinge);
            Append(text, skeleton.SpanAxis);
            Append(text, skeleton.UpAxis);
            foreach (JointChain chain in skeleton.Chains)
            {
                text.Append('\n').Append(chain.Length);
                for (int j = 0; j < chain.Length; j++)
                    Append(text, chain.joints[j]);
            }

            return text.ToString();
        }

        private static void Append(StringBuilder text, Vector3 v)
        {
            for (int k = 0; k < 3; k++)
                text.Append(' ').Append(BitConverter.SingleToInt32Bits(v[k]).ToString("x8"));
        }
    }
}
