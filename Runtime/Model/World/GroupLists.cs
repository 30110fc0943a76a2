using Unity.Collections.LowLevel.Unsafe;

namespace Alate
{
    /// <summary>Lists that the groups of the step job go by.</summary>
    internal unsafe struct GroupLists
    {
        [NativeDisableUnsafePtrRestriction] public WingPack* packs;
        [NativeDisableUnsafePtrRestriction] public FlyingBody* bodies;
        [NativeDisableUnsafePtrRestriction] public BodyWing* wings;

        /// <summary>Packs and bodies, group by group.</summary>
        [NativeDisableUnsafePtrRestriction] public int* packList;
        [NativeDisableUnsafePtrRestriction] public int* bodyList;

        /// <summary>Pack k of a group.</summary>
        public ref WingPack Pack(in PackGroup group, int k) => ref packs[packList[group.firstPack + k]];

        /// <summary>Body k of a group.</summary>
        public ref FlyingBody Body(in PackGroup group, int k) => ref bodies[bodyList[group.firstBody + k]];

        /// <summary>The beat of a body: that of its first wing.</summary>
        public BeatState* Beat(in FlyingBody body, out int lane)
        {
            BodyWing* wing = wings + body.firstWing;
            lane = wing->lane;
            return packs[wing->pack].beat;
        }

        /// <summary>Commands the next beat of a wing.</summary>
        public void Command(in BodyWing wing, in WingDrive drive)
        {
            LaneParameters* parameters = packs[wing.pack].parameters;
            parameters->drive.Set(wing.lane, drive, true);
            for (int lane = wing.firstCopy; lane < wing.endCopy; lane++)
                parameters->drive.Set(lane, drive, true);
        }
    }
}
