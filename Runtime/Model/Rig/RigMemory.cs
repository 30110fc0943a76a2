using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>The native arrays of a rig.</summary>
    internal sealed unsafe class RigMemory : IDisposable
    {
        public readonly NativeArray<float3> restJoints;
        public readonly NativeArray<float> jointMasses;
        public readonly NativeArray<Spring> springs;
        public readonly NativeArray<int4> vertexJoints;
        public readonly NativeArray<float4> vertexWeights;
        public readonly NativeArray<int> jointVertexStarts;
        public readonly NativeArray<int> jointVertices;
        public readonly RigView view;

        /// <summary>View of the rig with few patches.</summary>
        public readonly RigView coarseView;

        private readonly List<IDisposable> m_Owned = new List<IDisposable>();

        public RigMemory(RigContent content)
        {
            RestSkeleton rest = content.rest;
            restJoints = Own(rest.joints);
            jointMasses = Own(content.jointMasses);
            springs = Own(content.springs);
            vertexJoints = Own(content.influences.joints);
            vertexWeights = Own(content.influences.weights);
            jointVertexStarts = Own(content.influences.jointVertexStarts);
            jointVertices = Own(content.influences.jointVertices);
            view = new RigView
            {
                chainCount = rest.chainCount,
                jointsPerChain = rest.jointsPerChain,
                jointCount = rest.joints.Length,
                boneCount = rest.BoneCount,
                cellCount = rest.CellCount,
                springCount = content.springs.Length,
                vertexCount = content.influences.joints.Length,
                quadCount = content.skin.quads.Length,
                leadingEdge = rest.leadingEdge,
                skinReach = content.skin.reach,
                chainRatio = (float*)Pointer(rest.chainRatio),
                jointRatio = (float*)Pointer(rest.jointRatio),
                restJoints = (float3*)restJoints.GetUnsafeReadOnlyPtr(),
                bones = (float3*)Pointer(rest.bones),
                boneDirections = (float3*)Pointer(rest.boneDirections),
                bendAxes = (float3*)Pointer(rest.bendAxes),
                crossDirections = (float3*)Pointer(rest.crossDirections),
                jointMasses = (float*)jointMasses.GetUnsafeReadOnlyPtr(),
                jointInertias = (float*)Pointer(content.jointInertias),
                addedMasses = (float*)Pointer(content.addedMasses),
                addedInertias = (float*)Pointer(content.addedInertias),
                beamStiffness = (float*)Pointer(content.beams.bend),
                beamTorsion = (float*)Pointer(content.beams.torsion),
                veinFactors = (float*)Pointer(content.veinFactors),
                hasVeins = content.hasVeins,
                leverDamping = (float*)Pointer(content.leverDamping),
                strips = (Strip*)Pointer(content.strips.Strips),
                stripCount = content.strips.Strips.Length,
                stripLevers = (float*)Pointer(content.strips.Levers),
                fanWidths = (float*)Pointer(content.strips.FanWidths),
                spread = content.strips.Spread,
                flapShares = (float*)Pointer(FlapShares.Cumulative(rest, content.strips.Spread)),
                springs = (Spring*)springs.GetUnsafeReadOnlyPtr(),
                skinCells = (SkinCell*)Pointer(content.skin.cells),
                skinQuads = (SkinQuad*)Pointer(content.skin.quads),
                skinTangents = content.skin.tangents == null ? null : (SkinTangentQuad*)Pointer(content.skin.tangents),
            };
            coarseView = view;
            SetPatches(ref view, content.patches, rest);
            SetPatches(ref coarseView, content.coarsePatches, rest);
        }

        public void Dispose()
        {
            foreach (IDisposable array in m_Owned)
                array.Dispose();
        }

        private void SetPatches(ref RigView rig, PatchLayout patches, RestSkeleton rest)
        {
            rig.patchCount = patches.Count;
            rig.patchCells = (PatchCell*)Pointer(patches.cells);
            rig.patchU = (float*)Pointer(patches.u);
            rig.patchV = (float*)Pointer(patches.v);
            rig.patchSpan = (float*)Pointer(patches.span);
            rig.patchChord = (float*)Pointer(patches.chord);
            rig.patchQuarterChords = (float*)Pointer(patches.quarterChords);
            rig.patchAreas = (float*)Pointer(patches.areas);
            rig.patchMeasures = (float*)Pointer(patches.Measures(rest));
        }

        private void* Pointer<T>(T[] content) where T : struct => Own(content).GetUnsafeReadOnlyPtr();

        private NativeArray<T> Own<T>(T[] content) where T : struct
        {
            var array = new NativeArray<T>(content, Allocator.Persistent);
            m_Owned.Add(array);
            return array;
        }
    }
}
