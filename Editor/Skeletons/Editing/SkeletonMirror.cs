using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Makes the skeleton of the wing on the other side.</summary>
    internal static class SkeletonMirror
    {
        /// <summary>Default mirror: across the plane x = 0 of the mesh's space, as insects are modelled.</summary>
        public static Matrix4x4 AcrossX => Matrix4x4.Scale(new Vector3(-1f, 1f, 1f));

        /// <summary>Applies a mirror, or any affine map, to a draft.</summary>
        public static SkeletonDraft Reflect(SkeletonDraft draft, Matrix4x4 mirror)
        {
            SkeletonDraft image = draft.Copy();
            image.Hinge = mirror.MultiplyPoint3x4(draft.Hinge);
            image.SpanAxis = mirror.MultiplyVector(draft.SpanAxis);
            image.UpAxis = mirror.MultiplyVector(draft.UpAxis);
            for (int i = 0; i < draft.ChainCount; i++)
            {
                for (int j = 0; j < draft.JointsPerChain; j++)
                    image[i, j] = mirror.MultiplyPoint3x4(draft[i, j]);
            }

            return image;
        }

        /// <summary>Makes a new skeleton, the mirror image of another, which stays unchanged; null where that is refused.</summary>
        public static WingSkeleton Create(WingSkeleton skeleton, Matrix4x4 mirror, out string refusal)
        {
            refusal = SkeletonDraft.Read(skeleton, out SkeletonDraft draft);
            SkeletonDraft image = refusal == null ? Reflect(draft, mirror) : null;
            refusal ??= image.FindFault();
            if (refusal != null)
                return null;
            WingSkeleton made = ScriptableObject.CreateInstance<WingSkeleton>();
            made.name = OtherSide(skeleton.name);
            image.WriteTo(made);
            return made;
        }

        /// <summary>
        /// Name for the other side: "Left Wing" for "Right Wing" and so on; the name with "Mirrored" behind it where it names no side.
        /// </summary>
        public static string OtherSide(string name)
        {
            foreach ((string from, string to) in s_Sides)
            {
                int at = name.LastIndexOf(from, System.StringComparison.Ordinal);
                if (at >= 0 && IsWord(name, at, from.Length))
                    return name.Substring(0, at) + to + name.Substring(at + from.Length);
            }

            return name + " Mirrored";
        }

        // "right" names a side neither in "upright" nor in "rightful", and "_R" not in "_Root".
        private static bool IsWord(string name, int at, int length)
        {
            bool begins = at == 0 || !char.IsLower(name[at]) || !char.IsLetter(name[at - 1]);
            return begins && (at + length == name.Length || !char.IsLower(name[at + length]));
        }

        private static readonly (string from, string to)[] s_Sides =
        {
            ("Right", "Left"), ("Left", "Right"), ("right", "left"), ("left", "right"),
            ("_R", "_L"), ("_L", "_R"), (".R", ".L"), (".L", ".R"),
        };
    }
}
