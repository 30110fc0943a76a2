using System;
using System.Collections.Generic;

namespace Alate.Crowds
{
    /// <summary>A baked insect with fewer triangles: some of its vertices, with their frames.</summary>
    public static class SmallerBake
    {
        /// <summary>Least number of triangles that can be asked for.</summary>
        public const int MinTriangles = 50;

        /// <summary>Reduces the mesh of a bake.</summary>
        /// <param name="bake">The insect; it is not changed.</param>
        /// <param name="triangles">Most triangles, 50 or more.</param>
        /// <param name="error">Distance of the whole wings from the smaller mesh over all clips, root of the mean square, wing
        /// lengths.</param>
        /// <exception cref="ArgumentNullException">There is no bake.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Too few triangles.</exception>
        public static InsectBake Of(InsectBake bake, int triangles, out float error)
        {
            if (bake == null)
                throw new ArgumentNullException(nameof(bake));
            if (triangles < MinTriangles)
            {
                throw new ArgumentOutOfRangeException(
                    nameof(triangles), triangles, $"A smaller mesh has {MinTriangles} triangles or more.");
            }
            ReducedSurface reduced = ReducedSurface.Of(bake, new[] { triangles })[0];
            error = reduced.Error;
            var placeOf = new Dictionary<int, int>();
            foreach (int vertex in reduced.Vertices)
                placeOf.Add(vertex, placeOf.Count);
            return new InsectBake
            {
                Name = bake.Name,
                Surface = Surface(bake.Surface, reduced, placeOf),
                Wings = Map(bake.Wings, wing => Wing(wing, placeOf)),
                Abdomens = Map(bake.Abdomens, abdomen => Abdomen(abdomen, reduced.Vertices)),
                Clips = Map(bake.Clips, clip => Clip(clip, reduced.Vertices)),
                MetresPerUnit = bake.MetresPerUnit,
                WingLength = bake.WingLength,
                JointCount = bake.JointCount,
            };
        }

        private static BakedSurface Surface(BakedSurface whole, ReducedSurface reduced, Dictionary<int, int> placeOf)
        {
            var parts = new List<BakedPart>();
            for (int part = 0; part < whole.Parts.Count; part++)
            {
                BakedPart known = whole.Parts[part];
                if (reduced.Parts[part].Length > 0)
                {
                    parts.Add(new BakedPart(
                        known.Name, known.Material, known.HasColours, Array.ConvertAll(reduced.Parts[part], vertex => placeOf[vertex])));
                }
            }

            return new BakedSurface
            {
                Positions = Pick(whole.Positions, reduced.Vertices),
                Normals = Pick(whole.Normals, reduced.Vertices),
                Uvs = Pick(whole.Uvs, reduced.Vertices),
                Colours = Pick(whole.Colours, reduced.Vertices),
                Parts = parts,
            };
        }

        private static BakedWing Wing(BakedWing wing, Dictionary<int, int> placeOf)
        {
            var kept = new List<int>();
            for (int k = 0; k < wing.Vertices.Length; k++)
            {
                if (placeOf.ContainsKey(wing.Vertices[k]))
                    kept.Add(k);
            }

            int[] places = kept.ToArray();
            return new BakedWing
            {
                Name = wing.Name,
                Side = wing.Side,
                Length = wing.Length,
                Vertices = Array.ConvertAll(places, k => placeOf[wing.Vertices[k]]),
                FirstJoint = wing.FirstJoint,
                JointsPerChain = wing.JointsPerChain,
                RestJoints = wing.RestJoints,
                VertexJoints = Pick(wing.VertexJoints, places),
                VertexWeights = Pick(wing.VertexWeights, places),
            };
        }

        // Vertices are ascending, so that those of an abdomen stay behind one another.
        private static BakedAbdomen Abdomen(BakedAbdomen abdomen, int[] vertices)
        {
            int first = CountBelow(vertices, abdomen.FirstVertex);
            return new BakedAbdomen
            {
                Name = abdomen.Name,
                FirstVertex = first,
                VertexCount = CountBelow(vertices, abdomen.FirstVertex + abdomen.VertexCount) - first,
                Joint = abdomen.Joint,
                Hinge = abdomen.Hinge,
            };
        }

        private static int CountBelow(int[] ascending, int vertex)
        {
            int place = Array.BinarySearch(ascending, vertex);
            return place < 0 ? ~place : place;
        }

        private static BakedClip Clip(BakedClip clip, int[] vertices) => new BakedClip
        {
            Motion = clip.Motion,
            Frequency = clip.Frequency,
            Velocity = clip.Velocity,
            AngularVelocity = clip.AngularVelocity,
            Attitude = clip.Attitude,
            RightBeat = clip.RightBeat,
            LeftBeat = clip.LeftBeat,
            Frames = Map(clip.Frames, frame => Frame(frame, vertices)),
            Error = clip.Error,
        };

        private static BakedFrame Frame(BakedFrame frame, int[] vertices)
        {
            var smaller = new BakedFrame(vertices.Length, frame.Joints.Length);
            Pick(frame.Positions, vertices).CopyTo(smaller.Positions, 0);
            Pick(frame.Normals, vertices).CopyTo(smaller.Normals, 0);
            frame.Joints.CopyTo(smaller.Joints, 0);
            return smaller;
        }

        private static T[] Pick<T>(T[] values, int[] places) => Array.ConvertAll(places, place => values[place]);

        private static List<T> Map<T>(IReadOnlyList<T> list, Func<T, T> map)
        {
            var made = new List<T>(list.Count);
            foreach (T one in list)
                made.Add(map(one));
            return made;
        }
    }
}
