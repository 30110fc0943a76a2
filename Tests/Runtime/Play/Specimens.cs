using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Meshes for insects of tests.</summary>
    internal static class Specimens
    {
        /// <summary>A wing of a species.</summary>
        public static Mesh Mesh(SpeciesWing kind, WingSide side, float unitsPerMetre)
        {
            return kind.CreateSurface(side, unitsPerMetre).ToMesh(kind.Name + " " + side);
        }
    }
}
