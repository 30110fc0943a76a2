using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>
    /// A scene in which numbers of a component can act: many of it, alike to the bit, in one place; or one at a time, where they would meet
    /// each other.
    /// </summary>
    public sealed class KeyedScene
    {
        public KeyedScene(Func<Component> make, Func<Component, IEnumerable<float>> state)
        {
            Make = make;
            State = state;
        }

        /// <summary>Makes one of the component's objects.</summary>
        public Func<Component> Make { get; }

        /// <summary>All that a number can act on.</summary>
        public Func<Component, IEnumerable<float>> State { get; }

        /// <summary>Called before any is made.</summary>
        public Action Begin { get; set; }

        /// <summary>Called for each in each frame.</summary>
        public Action<Component> Step { get; set; }

        /// <summary>Called for each when the numbers have been written.</summary>
        public Action<Component> Then { get; set; }

        /// <summary>Frames before numbers are written, and after.</summary>
        public int Before { get; set; } = 20;

        public int After { get; set; } = 2;

        /// <summary>True where each is alone in the scene.</summary>
        public bool IsAlone { get; set; }
    }
}
