using Alate.Catalogue;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The monarch of the check values: a grid of 48 × 22 cells, in level flight at 1.3 m/s.</summary>
    internal static class Monarch
    {
        /// <summary>Wing length, metres.</summary>
        public const float Length = 0.061f;

        /// <summary>From the outline's base line to the hinge, wing lengths: check values are given from the base line.</summary>
        public static readonly float3 Hinge = new float3(0f, 0f, 0.3f / 61f);

        /// <summary>The wing's parameters.</summary>
        public static WingParameters Parameters => InsectCatalogue.Find("monarch").Wings[0].CreatePreset().ToParameters();

        /// <summary>
        /// The wing by <see cref="SpeciesFlight.FirstOrder"/>: what the check values of simulated flight were computed with.
        /// </summary>
        public static WingParameters FirstOrder => SpeciesFlight.FirstOrder(Parameters);

        /// <summary>Surroundings at a speed and a pitch of the body.</summary>
        public static WingSurroundings Flying(float speed = 1.3f, float pitch = 0f)
        {
            var toBody = quaternion.RotateX(pitch);
            return new WingSurroundings
            {
                wind = math.rotate(toBody, new float3(0f, 0f, -speed / Length)),
                gravity = math.rotate(toBody, new float3(0f, -9.81f / Length, 0f)),
                speed = speed,
                angleOfAttack = pitch,
            };
        }

        /// <summary>Rig on the grid; 0 patches for every triangle.</summary>
        public static WingRig GridRig(int patches = 0)
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
            SurfaceMesh grid = WingMesher.Grid(wing.Outline, 48, 22, (float)wing.Outline.Length * InsectDefinition.UnitsPerMetre);
            return Bake(wing, grid, patches);
        }

        /// <summary>Rig on the mesh that users get.</summary>
        public static WingRig Rig(int patches = 256)
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];
            return Bake(wing, wing.CreateSurface(WingSide.Right), patches);
        }

        private static WingRig Bake(WingDefinition wing, SurfaceMesh mesh, int patches)
        {
            var surface =
                new SurfaceMesh { name = wing.Name, positions = mesh.positions, normals = mesh.normals, triangles = mesh.triangles };
            return WingRig.Bake(wing.CreateSkeleton(WingSide.Right), surface, new WingRigSettings { patchCount = patches });
        }
    }
}
