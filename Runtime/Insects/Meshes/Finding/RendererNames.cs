using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>What the names around a renderer say: its own, its mesh's, those of its parents and of its materials.</summary>
    internal sealed class RendererNames
    {
        private readonly List<Material> m_Materials = new List<Material>();

        public RendererNames(Renderer renderer, Mesh mesh, Transform root)
        {
            renderer.GetSharedMaterials(m_Materials);
            Take(WingName.Read(renderer.name), true);
            Take(WingName.Read(mesh.name), true);
            for (var place = renderer.transform; place != root && place.parent != root && place.parent != null; place = place.parent)
                Take(WingName.Read(place.parent.name), false);
        }

        /// <summary>The renderer as a whole is called a wing, or lies below what is only called that.</summary>
        public bool IsWing { get; private set; }

        /// <summary>Whether the renderer is named as a wing's cover, or lies below one.</summary>
        public bool IsCase { get; private set; }

        /// <summary>The side by the nearest name that says one.</summary>
        public WingSide? Side { get; private set; }

        /// <summary>The pair by the nearest name that says one.</summary>
        public WingPair? Pair { get; private set; }

        /// <summary>The name of the material of a submesh; says nothing if there is none.</summary>
        public WingName Material(int submesh) =>
            WingName.Read(submesh < m_Materials.Count && m_Materials[submesh] != null ? m_Materials[submesh].name : null);

        private void Take(WingName name, bool isOwn)
        {
            IsWing |= isOwn ? name.IsWing : name.IsPlainWing;
            IsCase |= name.IsCase;
            Side = Side ?? name.Side;
            Pair = Pair ?? name.Pair;
        }
    }
}
