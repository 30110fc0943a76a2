using Unity.Mathematics;

namespace Alate
{
    /// <summary>Flight that carries an insect by its own wings, as the frame loop sees it: told before each step and each picture, with no jobs under way.</summary>
    internal interface IFlyingInsect
    {
        /// <summary>Prepares a step of the insect's clock.</summary>
        /// <param name="live">The wings.</param>
        /// <param name="world">Where they are.</param>
        /// <param name="wind">Air, world units per second.</param>
        /// <param name="gravity">World axes, m/s².</param>
        /// <param name="dt">Seconds.</param>
        void Prepare(LiveInsect live, WingWorld world, float3 wind, float3 gravity, float dt);

        /// <summary>Places the insect for a picture at a time within the last step, 0 its start, 1 its end.</summary>
        void Show(LiveInsect live, WingWorld world, float alpha);
    }
}
