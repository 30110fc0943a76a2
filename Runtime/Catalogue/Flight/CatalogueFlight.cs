using System;
using System.Collections.Generic;
using Alate.Flight;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Insects of the catalogue as models that fly by their own wings.</summary>
    public static class CatalogueFlight
    {
        /// <summary>[species] Shared by all insects that were made.</summary>
        private static readonly Dictionary<InsectDefinition, FlightTrims> s_Trims = new Dictionary<InsectDefinition, FlightTrims>();

        /// <summary>Makes the flight model of an insect: all its wings on both sides, its body and their masses. Dispose it.</summary>
        /// <param name="insect">The insect.</param>
        /// <param name="variant">Which numbers; <see cref="InsectVariant.Flight"/> are those that fly.</param>
        /// <exception cref="ArgumentException">The insect has no such variant, or no parts of the body.</exception>
        public static FlightModel CreateModel(InsectDefinition insect, InsectVariant variant = InsectVariant.Flight)
        {
            var wings = new List<FlightWing>();
            float mass = 0f, density = 0f, share = 0f, metresPerUnit = 0f;
            foreach (WingDefinition wing in insect.Wings)
            {
                WingPreset preset = wing.CreatePreset(ModelReading.Physical, variant);
                mass = preset.Size.insectMass;
                density = preset.Size.fluidDensity;
                share = preset.Size.gravityShare;
                Add(wings, wing, preset, ref metresPerUnit);
                UnityEngine.Object.DestroyImmediate(preset);
            }

            var model = new FlightModel(wings, insect.FlightParts, mass, density, share);
            for (int k = 0; k < wings.Count; k += 2)
            {
                wings[k].Rig.Release();
            }

            return model;
        }

        /// <summary>Trim table of an insect with its flight numbers. Dispose it after the flights that go by it.</summary>
        /// <param name="insect">The insect.</param>
        /// <param name="model">Its model.</param>
        /// <returns>The table; null where none is made for these numbers: <see cref="TrimBake"/> makes one.</returns>
        public static TrimTable CreateTable(InsectDefinition insect, FlightModel model) =>
            TrimTableText.Read(TrimTables.Of(insect), model.Key);

        /// <summary>
        /// Returns true where an insect has a trim table, by which it flies, or swims, with <see cref="InsectVariant.Flight"/>; whether
        /// that is of its numbers, <see cref="CreateTable"/> says.
        /// </summary>
        /// <param name="insect">The insect.</param>
        public static bool Flies(InsectDefinition insect) => TrimTables.Of(insect) != null;

        /// <summary>Lets an insect that was made with <see cref="InsectVariant.Flight"/> fly by its own wings.</summary>
        /// <param name="wings">The insect.</param>
        /// <param name="insect">Its species.</param>
        /// <exception cref="ArgumentException">There is no trim table of the species.</exception>
        public static InsectFlight AddTo(InsectWings wings, InsectDefinition insect)
        {
            if (!s_Trims.TryGetValue(insect, out FlightTrims trims) || trims == null)
            {
                trims = CreateTrims(insect);
                trims.hideFlags = HideFlags.HideAndDontSave;
                s_Trims[insect] = trims;
            }

            return AddTo(wings, insect, trims);
        }

        /// <summary>Makes an asset of an insect's trim table.</summary>
        /// <exception cref="ArgumentException">There is no trim table of the species.</exception>
        internal static FlightTrims CreateTrims(InsectDefinition insect)
        {
            if (!Flies(insect))
                throw new ArgumentException($"The {insect.DisplayName} has no trim table: it does not fly.", nameof(insect));
            var trims = FlightTrims.Create(TrimTables.Of(insect));
            trims.name = insect.DisplayName + " Flight Trims";
            return trims;
        }

        /// <summary>Lets an insect fly by a trim table of its species.</summary>
        internal static InsectFlight AddTo(InsectWings wings, InsectDefinition insect, FlightTrims trims)
        {
            InsectFlight flight = wings.gameObject.AddComponent<InsectFlight>();
            flight.Trims = trims;
            flight.Parts.AddRange(insect.FlightParts);
            return flight;
        }

        private static void Add(List<FlightWing> wings, WingDefinition wing, WingPreset preset, ref float metresPerUnit)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right);
            var rig = WingRig.Bake(skeleton, surface, WingRigSettings.Default);
            UnityEngine.Object.DestroyImmediate(skeleton);
            // As in a scene: the first wing's length tells how large an insect is, also where the numbers have longer wings than the mesh.
            if (wings.Count == 0)
                metresPerUnit = preset.WingLength / rig.Frame.length;
            float3 hinge = metresPerUnit * ((float3)wing.HingeOn(WingSide.Right) + rig.Frame.origin);
            foreach (float side in new[] { 1f, -1f })
            {
                wings.Add(new FlightWing
                {
                    Rig = rig,
                    Surface = surface,
                    Parameters = preset.ToParameters(),
                    Hinge = hinge * new float3(side, 1f, 1f),
                    Axes = new float3x3(new float3(side, 0f, 0f), new float3(0f, 1f, 0f), new float3(0f, 0f, 1f)),
                    Length = preset.WingLength,
                    Mass = preset.Size.wingMass,
                    GravityShare = preset.Size.gravityShare,
                    IsLeft = side < 0f,
                });
            }
        }
    }
}
