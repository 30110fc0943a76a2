using System;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Runs a test's action at some moment of the frame.</summary>
    internal sealed class Deeds : MonoBehaviour
    {
        public Action inFixedUpdate, inUpdate, inLateUpdate, whenDisabled, whenDestroyed;

        private void FixedUpdate() => Once(ref inFixedUpdate);

        private void Update() => Once(ref inUpdate);

        private void LateUpdate() => Once(ref inLateUpdate);

        private void OnDisable() => Once(ref whenDisabled);

        private void OnDestroy() => Once(ref whenDestroyed);

        private static void Once(ref Action deed)
        {
            Action now = deed;
            deed = null;
            now?.Invoke();
        }
    }
}
