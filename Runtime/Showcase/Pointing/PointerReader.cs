using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>
    /// Reads the pointer once a frame: by the Input System package where it is installed, active and has a device, else by the Input
    /// Manager. The events of IMGUI cannot serve: none but layout and repaint arrives where the Input System is the only back end.
    /// </summary>
    internal static class PointerReader
    {
        private static PointerFrame s_Now;
        private static int s_Frame = -1;

        /// <summary>Pointer in this frame.</summary>
        public static PointerFrame Now
        {
            get
            {
                if (s_Frame != Time.frameCount)
                {
                    s_Frame = Time.frameCount;
                    s_Now = Read();
                }

                return s_Now;
            }
        }

        // Frames are counted from the beginning of each play, and statics may outlive it.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => s_Frame = -1;

        private static PointerFrame Read()
        {
#if ALATE_INPUT_SYSTEM && ENABLE_INPUT_SYSTEM
            if (SystemPointer.HasDevice)
                return SystemPointer.Read();
#endif
#if ENABLE_LEGACY_INPUT_MANAGER
            return LegacyPointer.Read();
#else
            return new PointerFrame { digit = -1 };
#endif
        }
    }
}
