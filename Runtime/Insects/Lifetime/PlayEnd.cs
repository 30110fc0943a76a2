using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Detects the end of play: of the game in a player, of play mode in the editor. From then on nothing starts any more, and objects must
    /// be destroyed at once, because no further frame comes.
    /// </summary>
    internal static class PlayEnd
    {
        static PlayEnd() => Application.quitting += OnQuitting;

        /// <summary>Raised when play ends, before the scenes end.</summary>
        public static event Action Ended;

        /// <summary>True once play has ended.</summary>
        public static bool HasCome { get; private set; }

        /// <summary>Subscribes to the end of play; a recompile during play loses subscriptions.</summary>
        public static void Listen()
        {
            // The first call of anything here runs the static constructor.
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            HasCome = false;
            Ended = null;
            Application.quitting -= OnQuitting;
            Application.quitting += OnQuitting;
        }

        private static void OnQuitting()
        {
            HasCome = true;
            Ended?.Invoke();
        }
    }
}
