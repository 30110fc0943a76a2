using System;
using System.Collections.Generic;
using System.IO;
using Alate.Authoring;
using Alate.Catalogue;
using Alate.Files;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>One kind of wing of an insect in a scene, as an insect file has it.</summary>
    internal sealed class ExportedWing
    {
        private readonly Wing m_Wing;
        private readonly WingPreset m_Preset;
        private readonly Mesh m_Mesh;
        private readonly Transform m_Root;

        private ExportedWing(string name, Wing wing, WingPreset preset, Mesh mesh, Transform root)
        {
            Name = name;
            m_Wing = wing;
            m_Preset = preset;
            m_Mesh = mesh;
            m_Root = root;
        }

        /// <summary>Name of the wing in the file.</summary>
        public string Name { get; }

        /// <summary>Metres from hinge to tip.</summary>
        public float Length => m_Preset.WingLength;

        /// <summary>Metres of one unit of the insect's own space, as the wing's length has it.</summary>
        public float MetresPerUnit
        {
            get
            {
                float scale = Mathf.Abs(m_Wing.Renderer.transform.lossyScale.x / m_Root.lossyScale.x);
                return Length / (scale * WingFiles.FrameOf(m_Wing.Skeleton, SurfaceMesh.FromMesh(m_Mesh), m_Mesh.name).length);
            }
        }

        /// <summary>Finds the kinds of wings of an insect, from front to back, a right one where there is one.</summary>
        /// <exception cref="UserException">One of them cannot be written; the message says why.</exception>
        public static List<ExportedWing> Of(InsectWings insect)
        {
            var chosen = new List<Wing>();
            foreach (WingPair pair in new[] { WingPair.Fore, WingPair.Hind })
            {
                List<Wing> alike = insect.Wings.FindAll(wing => wing.Pair == pair && wing.Renderer != null);
                if (alike.Count > 0)
                    chosen.Add(alike.Find(wing => wing.Side == WingSide.Right) ?? alike[0]);
            }

            if (chosen.Count == 0)
                throw new UserException($"'{insect.name}' has no wings.");
            return chosen.ConvertAll(wing => Of(
                chosen.Count == 1 ? "wing" : wing.Pair == WingPair.Fore ? "fore wing" : "hind wing", wing, insect));
        }

        /// <summary>The wing with the shape of one of the catalogue, for its numbers.</summary>
        /// <param name="model">The wing of the catalogue.</param>
        /// <param name="metresPerUnit">Of the insect, by its first wing.</param>
        public WingDefinition Define(WingDefinition model, float metresPerUnit)
        {
            var wing = new WingDefinition(Name, model, Length, null) { Hinge = metresPerUnit * Hinge() };
            wing.Change(preset =>
            {
                preset.Size = m_Preset.Size;
                preset.Beat = m_Preset.Beat;
                preset.Wave = m_Preset.Wave;
                preset.Stiffness = m_Preset.Stiffness;
                preset.Rest = m_Preset.Rest;
                preset.Options = m_Preset.Options;
                preset.SubstepsPerBeat = m_Preset.SubstepsPerBeat;
            });
            return wing;
        }

        /// <summary>Writes mesh, skeleton and picture, and says what the insect file names.</summary>
        /// <param name="folder">Where to.</param>
        /// <param name="stem">Beginning of the names.</param>
        public JsonPlace Write(string folder, string stem)
        {
            var said = new JsonMembers();
            var surface = SurfaceMesh.FromMesh(m_Mesh);
            surface.uvs = Full(m_Mesh.uv);
            surface.colours = Full(m_Mesh.colors32);
            using (FileStream stream = File.Create(Path.Combine(folder, stem + ".obj")))
                ObjWriter.Write(surface, stream);
            File.WriteAllText(Path.Combine(folder, stem + ".json"), SkeletonJson.Write(m_Wing.Skeleton));
            said.Add(InsectKeys.Mesh, FileValue.Of(stem + ".obj"));
            said.Add(InsectKeys.Skeleton, FileValue.Of(stem + ".json"));
            byte[] picture = surface.uvs == null ? null : Picture(m_Wing.Renderer.sharedMaterial);
            if (picture != null)
            {
                File.WriteAllBytes(Path.Combine(folder, stem + ".png"), picture);
                said.Add(InsectKeys.Texture, FileValue.Of(stem + ".png"));
            }

            return said.ToPlace();
        }

        private static T[] Full<T>(T[] values) => values.Length == 0 ? null : values;

        private static ExportedWing Of(string name, Wing wing, InsectWings insect)
        {
            WingPreset preset = wing.Preset != null ? wing.Preset : insect.Preset;
            Mesh mesh = wing.Authored != null ? wing.Authored
                : wing.Renderer.TryGetComponent(out MeshFilter filter) ? filter.sharedMesh : null;
            string problem = preset == null ? "has no preset"
                : mesh == null ? "has no mesh"
                : !mesh.isReadable ? "has a mesh that cannot be read: tick Read/Write in its import settings"
                : wing.Part != WingPart.WholeMesh ? "is a part of a mesh: give it a mesh of its own"
                : wing.Skeleton == null || wing.Skeleton.Validate().Count > 0 ? "has no valid skeleton"
                : null;
            return problem == null
                ? new ExportedWing(name, wing, preset, mesh, insect.transform)
                : throw new UserException($"The {name} of '{insect.name}' {problem}.");
        }

        // Right, up and ahead of the body's origin, in its space.
        private Vector3 Hinge()
        {
            Vector3 place = m_Root.InverseTransformPoint(m_Wing.Renderer.transform.TransformPoint(m_Wing.Skeleton.Hinge));
            return new Vector3(Mathf.Abs(place.x), place.y, place.z);
        }

        // The file of a picture of the project, or the pixels of one that can be read.
        private static byte[] Picture(Material material)
        {
            if (material == null || !(material.SurfaceTexture() is Texture2D texture) || texture == null)
                return null;
            string path = AssetDatabase.GetAssetPath(texture);
            if (path.EndsWith(".png", StringComparison.OrdinalIgnoreCase))
                return File.ReadAllBytes(FileUtil.GetPhysicalPath(path));
            return texture.isReadable ? texture.EncodeToPNG() : null;
        }
    }
}
