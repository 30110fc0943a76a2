using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

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

        /// <summary>Number of substeps of a body, which are those of its wings, and their length, seconds.</summary>
        public int Substeps(in FlyingBody body, out float h)
        {
            BodyWing* wing = wings + body.firstWing;
            float4 substeps = packs[wing->pack].substeps, length = packs[wing->pack].substepLength;
            h = length[wing->lane];
            return (int)substeps[wing->lane];
        }

        /// <summary>Gives all wings of a body the largest number of substeps and the shortest time that one of them has.</summary>
        public void JoinSubsteps(in FlyingBody body)
        {
            float most = 1f, time = float.PositiveInfinity;
            for (int k = body.firstWing; k < body.firstWing + body.wingCount; k++)
            {
                float4 substeps = packs[wings[k].pack].substeps, whole = packs[wings[k].pack].substepLength;
                most = math.max(most, substeps[wings[k].lane]);
                time = math.min(time, whole[wings[k].lane]);
            }

            for (int k = body.firstWing; k < body.firstWing + body.wingCount; k++)
            {
                SetSubsteps(wings[k].pack, wings[k].lane, most, time);
                for (int lane = wings[k].firstCopy; lane < wings[k].endCopy; lane++)
                    SetSubsteps(wings[k].pack, lane, most, time);
            }
        }

        /// <summary>Commands the next beat of a wing.</summary>
        public void Command(in BodyWing wing, in WingDrive drive)
        {
            LaneParameters* parameters = packs[wing.pack].parameters;
            parameters->drive.Set(wing.lane, drive, true);
            for (int lane = wing.firstCopy; lane < wing.endCopy; lane++)
                parameters->drive.Set(lane, drive, true);
        }

        /// <summary>Lets all wings of a body meet the air of the wake at a point of its table.</summary>
        /// <param name="body">The body.</param>
        /// <param name="point">A <see cref="TrimPoint"/>; null for air at rest.</param>
        /// <param name="drive">Beat of the wings, by whose speed the air is scaled.</param>
        public void MeetWake(in FlyingBody body, float* point, in WingDrive drive)
        {
            if (!body.table.HasWake)
                return;
            float share = point == null ? 0f : BodyWake.Share(point, drive);
            for (int k = body.firstWing; k < body.firstWing + body.wingCount; k++)
            {
                WingInflow air = point == null ? default : BodyWake.At(point, wings[k].pair) * share;
                LaneInflow* inflow = packs[wings[k].pack].inflow;
                inflow->Set(wings[k].lane, air);
                for (int lane = wings[k].firstCopy; lane < wings[k].endCopy; lane++)
                    inflow->Set(lane, air);
            }
        }

        private void SetSubsteps(int pack, int lane, float count, float time)
        {
            packs[pack].substeps[lane] = count;
            packs[pack].substepLength[lane] = time;
        }
    }
}
