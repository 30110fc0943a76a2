using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Flight that carries an insect by its own wings, as the frame loop sees it: told before each step and each picture, with no jobs
    /// under way.
    /// </summary>
    internal interface IFlyingInsect
    {
        /// <summary>Prepares the steps that the insect's clock takes at once.</summary>
        /// <param name="live">The wings.</param>
        /// <param name="world">Where they are.</param>
        /// <param name="wind">Air, world units per second.</param>
        /// <param name="gravity">World axes, m/s².</param>
        /// <param name="length">Seconds of a step of the wings.</param>
        /// <param name="count">Number of steps of the wings.</param>
        void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float length, int count);

        /// <summary>Places the insect for a picture at a time within the last step, 0 its start, 1 its end.</summary>
        void Show(LiveInsect live, WingWorld world, float alpha);
    }
}
