using System;
using System.Collections.Generic;
using Alate.Flight;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Catalogue
{
    /// <summary>
    /// Parts of the wings of one kind, left and right alike: the left wing is the right one with its X axis turned round.
    /// </summary>
    [Serializable]
    internal sealed class GeneratedWing
    {
        [NonSerialized] public WingDefinition kind;

        /// <summary>The right wing, its origin at the base.</summary>
        public Mesh mesh;

        /// <summary>Skeleton in the space of the mesh.</summary>
        public WingSkeleton skeleton;

        /// <summary>Colours and light.</summary>
        public Material material;
    }

    /// <summary>Meshes, skeletons and materials that the insects of one species share; assembles insects of them.</summary>
    internal sealed class InsectParts
    {
        private const string k_Body = "Body", k_Abdomen = "Abdomen";

        private static readonly WingSide[] s_Sides = { WingSide.Right, WingSide.Left };

        /// <param name="name">Display name of the insect.</param>
        /// <param name="wings">The kinds of wings.</param>
        public InsectParts(string name, IReadOnlyList<GeneratedWing> wings)
        {
            Name = name;
            Wings = wings;
        }

        /// <summary>Names the kinds of wings of an insect.</summary>
        /// <param name="species">The insect.</param>
        /// <param name="wings">Its wings, filled already or from now on.</param>
        public static InsectParts Of(InsectDefinition species, List<GeneratedWing> wings)
        {
            for (int k = 0; k < species.Wings.Count; k++)
            {
                if (k == wings.Count)
                    wings.Add(new GeneratedWing());
                wings[k].kind = species.Wings[k];
            }

            return new InsectParts(species.DisplayName, wings) { Swing = species.Abdomen };
        }

        /// <summary>Display name of the insect.</summary>
        public string Name { get; }

        /// <summary>The kinds of wings, from front to back.</summary>
        public IReadOnlyList<GeneratedWing> Wings { get; }

        /// <summary>The body.</summary>
        public Mesh BodyMesh { get; set; }

        /// <summary>The abdomen, where it swings; else null.</summary>
        public Mesh AbdomenMesh { get; set; }

        /// <summary>Part of the body that is the abdomen; without a swing where none does.</summary>
        private BodyEllipsoid Swing { get; set; }

        /// <summary>Material with the colours of the body.</summary>
        public Material BodyMaterial { get; set; }

        /// <summary>Makes new meshes, skeletons and materials, which the caller owns.</summary>
        /// <param name="species">Of what insect.</param>
        /// <param name="keepPixels">Whether the textures of the materials can be read, to be saved.</param>
        /// <exception cref="InvalidOperationException">No shader was found.</exception>
        public static InsectParts Make(InsectDefinition species, bool keepPixels = false)
        {
            InsectParts parts = Of(species, new List<GeneratedWing>());
            try
            {
                parts.BodyMaterial = WingMaterial.ForBody(species, WingMaterial.DefaultTextureSize, keepPixels);
                SurfaceMesh abdomen = null;
                SurfaceMesh body = parts.Swing.swing == 0f
                    ? species.Body.CreateSurface(InsectDefinition.UnitsPerMetre)
                    : species.Body.CreateParts(InsectDefinition.UnitsPerMetre, parts.Swing.Hinge, out abdomen);
                parts.BodyMesh = body.ToMesh($"{parts.Name} {k_Body} Mesh");
                parts.AbdomenMesh = abdomen?.ToMesh($"{parts.Name} {k_Abdomen} Mesh");
                foreach (GeneratedWing wing in parts.Wings)
                    Fill(wing, parts.NameOf(wing), keepPixels);
            }
            catch
            {
                parts.Destroy();
                throw;
            }

            return parts;
        }

        /// <summary>[wing] New presets of all kinds of wings.</summary>
        public WingPreset[] CreatePresets(InsectVariant variant, ModelReading reading)
        {
            var made = new WingPreset[Wings.Count];
            for (int k = 0; k < made.Length; k++)
            {
                made[k] = Wings[k].kind.CreatePreset(reading, variant);
                made[k].name = $"{NameOf(Wings[k])} Preset{(variant == InsectVariant.Standard ? "" : " " + variant)}";
            }

            return made;
        }

        /// <summary>An insect of these parts, inactive: body and wings below a root with <see cref="InsectWings"/>.</summary>
        /// <param name="presets">[wing] How the wings beat.</param>
        public GameObject Assemble(WingPreset[] presets)
        {
            var root = new GameObject(Name);
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            Draw(root.transform, k_Body, BodyMesh, BodyMaterial);
            if (AbdomenMesh != null)
                AttachAbdomen(root.transform);
            insect.Wings.Clear();
            insect.Preset = presets[0];
            for (int k = 0; k < Wings.Count; k++)
            {
                foreach (WingSide side in s_Sides)
                {
                    Wing wing = Attach(root.transform, Wings[k], side);
                    wing.Pair = k == 0 ? WingPair.Fore : WingPair.Hind;
                    wing.Preset = k == 0 ? null : presets[k];
                    insect.Wings.Add(wing);
                }
            }

            return root;
        }

        /// <summary>Hides all parts and keeps them from being saved in scenes or unloaded with them.</summary>
        public void Hide()
        {
            foreach (Object part in Parts())
            {
                part.hideFlags = HideFlags.HideAndDontSave;
                if (part is Material material && material.SurfaceTexture() is Texture texture && texture != null)
                    texture.hideFlags = HideFlags.HideAndDontSave;
            }
        }

        /// <summary>Destroys all parts.</summary>
        public void Destroy()
        {
            foreach (Object part in Parts())
            {
                if (part is Material material && material != null)
                    ObjectEnd.Destroy(material.SurfaceTexture());
                ObjectEnd.Destroy(part);
            }
        }

        // Everything there is, one by one; textures not, which go with their materials.
        private IEnumerable<Object> Parts()
        {
            yield return BodyMesh;
            if (AbdomenMesh != null)
                yield return AbdomenMesh;
            yield return BodyMaterial;
            foreach (GeneratedWing wing in Wings)
            {
                yield return wing.mesh;
                yield return wing.skeleton;
                yield return wing.material;
            }
        }

        private string NameOf(GeneratedWing wing) => $"{Name} {Title(wing.kind.Name)}";

        private static void Fill(GeneratedWing part, string name, bool keepPixels)
        {
            part.material = WingMaterial.ForWing(part.kind, WingMaterial.DefaultTextureSize, keepPixels);
            part.material.name = name;
            part.skeleton = part.kind.CreateSkeleton(WingSide.Right);
            part.skeleton.name = name + " Skeleton";
            part.mesh = part.kind.CreateSurface(WingSide.Right).ToMesh(name + " Mesh");
        }

        private void AttachAbdomen(Transform body)
        {
            Transform abdomen = Draw(body, k_Abdomen, AbdomenMesh, BodyMaterial).transform;
            abdomen.localPosition = InsectDefinition.UnitsPerMetre * Swing.Hinge;
            AbdomenSwing swing = abdomen.gameObject.AddComponent<AbdomenSwing>();
            swing.Swing = Swing.swing;
            swing.LowestPhase = Mathf.Repeat(Swing.lowestPhase, 360f);
        }

        private static Wing Attach(Transform body, GeneratedWing part, WingSide side)
        {
            MeshRenderer renderer = Draw(body, $"{Title(part.kind.Name)} {side}", part.mesh, part.material);
            renderer.transform.localPosition = part.kind.HingeOn(side);
            renderer.transform.localScale = new Vector3(side == WingSide.Right ? 1f : -1f, 1f, 1f);
            return new Wing { Renderer = renderer, Skeleton = part.skeleton, Side = side };
        }

        private static MeshRenderer Draw(Transform parent, string name, Mesh mesh, Material material)
        {
            var drawn = new GameObject(name);
            drawn.transform.SetParent(parent, false);
            drawn.AddComponent<MeshFilter>().sharedMesh = mesh;
            MeshRenderer renderer = drawn.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            return renderer;
        }

        // "fore wing" is "Fore Wing" as an object's name.
        private static string Title(string name)
        {
            string[] words = name.Split(' ');
            return string.Join(" ", Array.ConvertAll(words, word => char.ToUpperInvariant(word[0]) + word.Substring(1)));
        }
    }
}
