using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Takes the wings out of a mesh and bakes their rigs; reports problems instead of throwing.</summary>
    internal readonly struct RiggedParts
    {
        private readonly AutomaticSkeleton m_Automatic;
        private readonly int m_Patches;
        private readonly bool m_Smaller;

        /// <param name="mesh">A readable mesh.</param>
        /// <param name="automatic">For wings without a skeleton.</param>
        /// <param name="patches">Surface patches of each wing.</param>
        /// <param name="smaller">Whether smaller parts are wanted as well.</param>
        public RiggedParts(Mesh mesh, in AutomaticSkeleton automatic, int patches, bool smaller = false)
        {
            m_Smaller = smaller;
            Mesh = mesh;
            m_Automatic = automatic;
            m_Patches = patches;
        }

        /// <summary>The mesh that the wings are part of.</summary>
        public Mesh Mesh { get; }

        /// <summary>Makes a part for each wing; the indices are their places in the insect's list, for messages.</summary>
        /// <returns>Null when there is a problem.</returns>
        public RiggedPart[] Build(Wing[] wings, List<int> indices, out InsectProblem problem)
        {
            var shapes = new RiggedPart[wings.Length];
            for (int w = 0; w < wings.Length; w++)
            {
                problem = Build(wings[w], indices[w], out shapes[w]);
                for (int other = 0; other < w && !problem.IsProblem; other++)
                {
                    if (shapes[w].Overlaps(shapes[other]))
                    {
                        problem = new InsectProblem(InsectState.WingsOverlap, indices[w],
                            $"it shares vertices of mesh '{Mesh.name}' with wing "
                            + $"{indices[other]}. Give each a part of its own: a submesh, or a connected part.");
                    }
                }

                if (!problem.IsProblem)
                    continue;
                foreach (RiggedPart shape in shapes)
                    shape?.Rig.Release();
                return null;
            }

            problem = InsectProblem.None;
            return shapes;
        }

        private InsectProblem Build(Wing wing, int index, out RiggedPart shape)
        {
            shape = null;
            MeshSelection selection;
            try
            {
                selection = MeshParts.Select(Mesh, wing.Part, wing.Submesh, wing.Point);
            }
            catch (ArgumentException exception)
            {
                return new InsectProblem(InsectState.NoSuchPart, index, $"{OneLine(exception)} Choose another part.");
            }

            SurfaceMesh surface = MeshParts.Surface(Mesh, selection);
            SmallerPart smaller = m_Smaller ? SmallerPart.Of(Mesh, selection) : null;
            WingSkeleton skeleton = wing.Skeleton;
            bool automatic = skeleton == null;
            try
            {
                if (automatic)
                    skeleton = m_Automatic.Fit(surface).Skeleton;
                var settings = new WingRigSettings { patchCount = m_Patches };
                if (smaller != null)
                {
                    selection = smaller.selection;
                    surface = MeshParts.Surface(Mesh, selection);
                    settings.smallerVertices = smaller.vertexCount;
                }

                shape = new RiggedPart(selection, WingRig.Bake(skeleton, surface, settings), smaller);
                return InsectProblem.None;
            }
            catch (ArgumentException exception)
            {
                return automatic
                    ? new InsectProblem(InsectState.NoSkeleton, index,
                        "it has no skeleton, and none could be laid out on mesh "
                        + $"'{Mesh.name}': {OneLine(exception)} Make a Wing Skeleton and assign it.")
                    : new InsectProblem(InsectState.SkeletonDoesNotFit, index,
                        $"{OneLine(exception)} Assign the skeleton that was made for mesh '{Mesh.name}'.");
            }
            finally
            {
                if (automatic)
                    ObjectEnd.Destroy(skeleton);
            }
        }

        // Without the "(Parameter 'x')" that .NET adds.
        internal static string OneLine(ArgumentException exception)
        {
            string message = exception.Message;
            int end = exception.ParamName == null ? -1 : message.IndexOf(" (Parameter '", StringComparison.Ordinal);
            if (end < 0 && exception.ParamName != null)
                end = message.IndexOf("\nParameter name:", StringComparison.Ordinal);
            return (end < 0 ? message : message.Substring(0, end)).Trim().Replace("\r", "").Replace("\n", " ");
        }
    }
}
