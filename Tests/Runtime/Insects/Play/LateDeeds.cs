using System;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Runs a test's action after the wings were stepped or drawn.</summary>
    [DefaultExecutionOrder(32000)]
    internal sealed class LateDeeds : MonoBehaviour
    {
        public Action inFixedUpdate, inLateUpdate;

        private void FixedUpdate() => Once(ref inFixedUpdate);

        private void LateUpdate() => Once(ref inLateUpdate);

        private static void Once(ref Action deed)
        {
            Action now = deed;
            deed = null;
            now?.Invoke();
        }
    }
}
