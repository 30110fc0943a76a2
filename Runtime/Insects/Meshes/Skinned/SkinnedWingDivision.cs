using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using UnityEngine;

namespace Alate
{
    /// <summary>Divides the wing triangles of a skinned mesh into wings, each with the bone that carries it.</summary>
    internal sealed class SkinnedWingDivision
    {
        private const int k_NoBone = -1;

        // Share of the weight in a connected part from which the bones of either pair make it a fore and a hind wing.
        private const float k_Pair = 0.2f;

        private readonly TriangleSet m_Wings;
        private readonly WingBones m_Bones;
        private readonly Vector3[] m_Positions;
        private readonly Matrix4x4 m_ToInsect;
        private readonly DisjointSets m_Sets;

        // [set] The side of a connected part, none if it reaches over both; and whether bones of a fore and of a hind wing move it.
        private readonly Dictionary<int, (WingSide? side, bool hasBothPairs)> m_Parts = new Dictionary<int, (WingSide?, bool)>();

        private SkinnedWingDivision(TriangleSet wings, WingBones bones, Vector3[] positions, Matrix4x4 toInsect)
        {
            m_Wings = wings;
            m_Bones = bones;
            m_Positions = positions;
            m_ToInsect = toInsect;
            m_Sets = MeshParts.Connect(wings.Corners(), positions);
        }

        /// <summary>Divides the wings, ordered fore right, fore left, hind right, hind left.</summary>
        /// <param name="wings">The triangles of all; not empty.</param>
        /// <param name="bones">The bones and weights of the mesh.</param>
        /// <param name="positions">The vertices of the mesh.</param>
        /// <param name="toInsect">From mesh space to the insect's.</param>
        public static List<SkinnedWing> Run(TriangleSet wings, WingBones bones, Vector3[] positions, Matrix4x4 toInsect)
        {
            var division = new SkinnedWingDivision(wings, bones, positions, toInsect);
            division.MeasureParts();
            return division.Merge();
        }

        private void MeasureParts()
        {
            foreach (KeyValuePair<int, int[][]> part in m_Wings.Divide((a, b, c) => m_Sets.Find(a)))
            {
                var shape = WingShape.Of(m_Positions, MeshSelection.Of(part.Value), m_ToInsect);
                m_Parts.Add(part.Key, (shape.Side, HasBothPairs(part.Value.SelectMany(own => own).ToArray())));
            }
        }

        // Parts of one side that one bone carries move as one: membrane and veins, or a thin wing's two faces.
        private List<SkinnedWing> Merge()
        {
            var merged = new Dictionary<(int Bone, WingSide Side), List<int>[]>();
            foreach (KeyValuePair<(int Set, WingSide Side, WingPair Pair), int[][]> piece in m_Wings.Divide(PieceOf))
            {
                (int, WingSide Side) key = (Carrier(piece.Value.SelectMany(own => own).ToArray()), piece.Key.Side);
                if (!merged.TryGetValue(key, out List<int>[] own))
                    merged.Add(key, own = Array.ConvertAll(piece.Value, _ => new List<int>()));
                for (int submesh = 0; submesh < own.Length; submesh++)
                    own[submesh].AddRange(piece.Value[submesh]);
            }

            var wings = new List<SkinnedWing>();
            foreach (KeyValuePair<(int Bone, WingSide Side), List<int>[]> one in merged)
                wings.Add(Made(one.Key.Bone, Array.ConvertAll(one.Value, own => own.ToArray())));
            WingPairing.Assign(wings.ConvertAll(wing => wing.place));
            wings.Sort((a, b) => WingPairing.Compare(a.place, b.place));
            return wings;
        }

        private (int Set, WingSide Side, WingPair Pair) PieceOf(int a, int b, int c)
        {
            int set = m_Sets.Find(a);
            (WingSide? side, bool hasBothPairs) part = m_Parts[set];
            Vector3 middle = m_ToInsect.MultiplyPoint3x4((m_Positions[a] + m_Positions[b] + m_Positions[c]) / 3f);
            WingSide side = part.side ?? (middle.x < 0f ? WingSide.Left : WingSide.Right);
            return (set, side, part.hasBothPairs ? PairOf(new[] { a, b, c }) : WingPair.Fore);
        }

        private SkinnedWing Made(int bone, int[][] submeshes)
        {
            WingName name = bone == k_NoBone ? default : m_Bones.Name(bone);
            var shape = WingShape.Of(m_Positions, MeshSelection.Of(submeshes), m_ToInsect);
            var place = new WingCandidate { shape = shape, namedSide = name.Side, pair = name.Pair };
            return new SkinnedWing { bone = bone, submeshes = submeshes, place = place };
        }

        private int Carrier(int[] corners)
        {
            if (!m_Bones.IsSkinned)
                return k_NoBone;
            int heaviest = Heaviest(Weights(corners));
            return m_Bones[heaviest] == null ? heaviest : m_Bones.RootOf(heaviest);
        }

        private WingPair PairOf(int[] corners) => m_Bones.Name(Heaviest(Weights(corners))).Pair ?? WingPair.Fore;

        private bool HasBothPairs(int[] corners)
        {
            float fore = 0f, hind = 0f;
            float[] weights = Weights(corners);
            for (int bone = 0; bone < weights.Length; bone++)
            {
                fore += m_Bones.Name(bone).Pair == WingPair.Fore ? weights[bone] : 0f;
                hind += m_Bones.Name(bone).Pair == WingPair.Hind ? weights[bone] : 0f;
            }

            return Mathf.Min(fore, hind) > k_Pair * corners.Length;
        }

        private float[] Weights(int[] corners)
        {
            float[] sums = new float[m_Bones.Count];
            if (m_Bones.IsSkinned)
            {
                foreach (int corner in corners)
                    m_Bones.AddWeights(corner, sums);
            }

            return sums;
        }

        private static int Heaviest(float[] weights)
        {
            int heaviest = 0;
            for (int bone = 1; bone < weights.Length; bone++)
                heaviest = weights[bone] > weights[heaviest] ? bone : heaviest;
            return heaviest;
        }
    }
}
