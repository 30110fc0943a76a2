using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Holds on to what an insect made by <see cref="InsectFactory"/> shares with others of its kind: it is freed when the last of them, clones included, is destroyed.
    /// </summary>
    [AddComponentMenu("")]
    [DisallowMultipleComponent]
    public sealed class GeneratedInsect : MonoBehaviour
    {
        // Serialised, so that a clone knows it too.
        [SerializeField, HideInInspector]
        InsectKind m_Kind;

        internal InsectKind Kind
        {
            set => m_Kind = value;
        }

        private void Awake() => InsectKits.Take(m_Kind);

        private void OnDestroy() => InsectKits.Return(m_Kind);
    }
}
