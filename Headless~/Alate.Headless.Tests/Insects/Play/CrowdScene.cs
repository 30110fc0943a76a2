using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Crowds;
using Unity.Collections;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>A crowd of one species before a camera, and what it draws.</summary>
    internal sealed class CrowdScene
    {
        /// <summary>Triangles of the meshes: fewer than those of a game, which take longer to make.</summary>
        public static readonly int[] Triangles = [400, 130, 50];

        /// <summary>By insect and clips: frames and smaller meshes are numbers, and the same for every scene.</summary>
        private static readonly Dictionary<string, (InsectBake Bake, ReducedSurface[] Reduced)> s_Flown = [];

        private readonly List<Object> m_Made = new List<Object>();

        /// <param name="species">The insects.</param>
        /// <param name="count">How many.</param>
        /// <param name="clips">Loops.</param>
        public CrowdScene(string species, int count, params string[] clips)
            : this(species, InsectVariant.Standard, count, clips)
        {
        }

        /// <param name="species">The insects.</param>
        /// <param name="variant">Those that fly are baked by their trims.</param>
        /// <param name="count">How many.</param>
        /// <param name="clips">Loops.</param>
        public CrowdScene(string species, InsectVariant variant, int count, params string[] clips)
        {
            ProjectShaders.Add(WingMaterial.ShaderName, "Alate/Wing");
            Prefab = InsectFactory.Create(InsectCatalogue.Find(species), variant);
            if (variant == InsectVariant.Flight)
                CatalogueFlight.AddTo(Prefab, InsectCatalogue.Find(species));
            Prefab.transform.position = new Vector3(0f, 0f, -100f);
            (Bake, ReducedSurface[] reduced) = BakeOf(Prefab, $"{species} {variant} {string.Join(' ', clips)}", clips);
            Baked = BakedInsect.Create(Bake, reduced);
            Prefab.gameObject.SetActive(false);
            var eye = new GameObject("eye");
            Camera = eye.AddComponent<Camera>();
            eye.transform.position = new Vector3(0f, 0f, -10f);
            Crowd = new GameObject("crowd").AddComponent<InsectCrowd>();
            Crowd.Insect = Baked;
            Crowd.Count = count;
            Crowd.Camera = Camera;
            m_Made.AddRange(new Object[] { Prefab.gameObject, eye, Crowd.gameObject, Baked });
        }

        public InsectWings Prefab { get; }

        public InsectBake Bake { get; }

        public BakedInsect Baked { get; }

        public Camera Camera { get; }

        public InsectCrowd Crowd { get; }

        /// <summary>Sets a pose.</summary>
        public void Place(int insect, CrowdPose pose)
        {
            NativeArray<CrowdPose> poses = Crowd.Poses;
            poses[insect] = pose;
        }

        /// <summary>One vertex of the wings of each drawn insect as the shader places it, from the texture, in world space.</summary>
        public static float3 Played(DrawnBatch batch, int instance, int vertex)
        {
            var texture = (Texture2D)batch.Material.GetTexture("_BakeMap");
            Color[] pixels = texture.GetPixels();
            var coordinates = new List<Vector2>();
            batch.Mesh.GetUVs(1, coordinates);
            Vector4 rows = batch.Properties["_BakeRows"][instance], next = batch.Properties["_BakeNextRows"][instance];
            float3 place = math.lerp(Loop(rows), Loop(next), rows.w);
            return batch.Matrices[instance].MultiplyPoint3x4(place);

            float3 Loop(Vector4 at) => math.lerp(Row(at.x), Row(at.y), at.z);

            float3 Row(float row)
            {
                int x = (int)(coordinates[vertex].x * texture.width), y = (int)(coordinates[vertex].y * texture.height + row);
                Color pixel = pixels[y * texture.width + x];
                return new float3((float)(Half)pixel.r, (float)(Half)pixel.g, (float)(Half)pixel.b);
            }
        }

        // The frames that an earlier scene flew, on the surface of this one, whose materials live as long as its insect.
        private static (InsectBake Bake, ReducedSurface[] Reduced) BakeOf(InsectWings insect, string key, string[] clips)
        {
            if (!s_Flown.TryGetValue(key, out (InsectBake Bake, ReducedSurface[] Reduced) known))
            {
                InsectBake first = InsectBaker.Bake(insect, Array.ConvertAll(clips, BakeMotion.Find), BakeSettings.Default);
                return s_Flown[key] = (first, ReducedSurface.Of(first, Triangles));
            }

            using var drawn = new DrawnInsect(insect);
            InsectBake flown = known.Bake, bake = new()
            {
                Name = insect.name,
                Surface = drawn.Surface(),
                Wings = flown.Wings,
                Abdomens = flown.Abdomens,
                Clips = flown.Clips,
                MetresPerUnit = flown.MetresPerUnit,
                WingLength = flown.WingLength,
                JointCount = flown.JointCount,
            };
            return (bake, known.Reduced);
        }

        public void Clear()
        {
            DrawnInstances.Calls = null;
            Crowd.enabled = false;
            Baked.DestroyParts();
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
            ProjectShaders.Clear();
        }
    }
}
