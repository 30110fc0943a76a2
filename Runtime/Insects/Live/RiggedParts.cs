using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Takes the wings out of a mesh and bakes their rigs; says what is wrong instead of throwing.</summary>
    internal static class RiggedParts
    {
        /// <summary>A shape for each wing.</summary>
        /// <returns>Null when there is a problem.</returns>
        public static RiggedPart[] Build(Mesh mesh, Wing[] wings, int[] indices, int patches, out InsectProblem problem)
        {
            var shapes = new RiggedPart[wings.Length];
            for (int w = 0; w < wings.Length; w++)
            {
                problem = Build(mesh, wings[w], indices[w], patches, out shapes[w]);
                for (int other = 0; other < w && !problem.IsProblem; other++)
                {
                    if (shapes[w].Overlaps(shapes[other]))
                    {
                        problem = new InsectProblem(InsectState.WingsOverlap, indices[w],
                            $"Wings {indices[other]} and {indices[w]} share vertices of mesh '{mesh.name}'. Give each a part of its own: a submesh, or a connected part.");
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

        private static InsectProblem Build(Mesh mesh, Wing wing, int index, int patches, out RiggedPart shape)
        {
            shape = null;
            MeshSelection selection;
            try
            {
                selection = MeshParts.Select(mesh, wing.Part, wing.Submesh, wing.Point);
            }
            catch (ArgumentException exception)
            {
                return new InsectProblem(InsectState.NoSuchPart, index, $"Wing {index}: {OneLine(exception)} Choose another part.");
            }

            WingSurface surface = MeshParts.Surface(mesh, selection);
            WingSkeleton skeleton = wing.Skeleton;
            bool automatic = skeleton == null;
            try
            {
                if (automatic)
                    skeleton = AutomaticSkeleton.Fit(surface, wing.Side);
                shape = new RiggedPart(selection, WingRig.Bake(skeleton, surface, new WingRigSettings { patchCount = patches }));
                return InsectProblem.None;
            }
            catch (ArgumentException exception)
            {
                return automatic
                    ? new InsectProblem(InsectState.NoSkeleton, index,
                        $"Wing {index} has no skeleton, and none could be laid out on mesh '{mesh.name}': {OneLine(exception)} Make a Wing Skeleton and assign it.")
                    : new InsectProblem(InsectState.SkeletonDoesNotFit, index,
                        $"Wing {index}: {OneLine(exception)} Assign the skeleton that was made for mesh '{mesh.name}'.");
            }
            finally
            {
                if (automatic)
                    ObjectEnd.Destroy(skeleton);
            }
        }

        // Without the "(Parameter 'x')" that .NET adds.
        private static string OneLine(ArgumentException exception)
        {
            string message = exception.Message;
            int end = exception.ParamName == null ? -1 : message.IndexOf(" (Parameter '", StringComparison.Ordinal);
            if (end < 0 && exception.ParamName != null)
                end = message.IndexOf("\nParameter name:", StringComparison.Ordinal);
            return (end < 0 ? message : message.Substring(0, end)).Trim().Replace("\r", "").Replace("\n", " ");
        }
    }
}
