using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>One fixed step of a group: the packs' substeps, and after each of them the bodies that the wings carry.</summary>
    internal static unsafe class GroupStep
    {
        /// <summary>Substeps before the latch at which the feedback samples: at least a quarter of one stays between.</summary>
        private const float k_SampleAhead = 1.25f;

        /// <summary>
        /// Beats that wings settle, with the one that is under way, before they carry a body again that followed its reference.
        /// </summary>
        private const int k_SettledBeats = 2;

        /// <summary>Rate at which an insect whose wings are not computed follows its reference, 1/s.</summary>
        private const float k_Following = 5f;

        /// <summary>Steps all packs and bodies of a group.</summary>
        /// <param name="group">What to step.</param>
        /// <param name="lists">The job's lists.</param>
        /// <param name="scratch">Of the worker.</param>
        /// <param name="dt">Seconds.</param>
        /// <param name="substeps">Substeps, for measurements; 0 lets the wings choose.</param>
        public static void Run(in PackGroup group, in GroupLists lists, in StepScratch scratch, float dt, int substeps)
        {
            if (group.bodyCount == 0)
            {
                PackStep.Run(ref lists.Pack(group, 0), scratch, dt);
                return;
            }

            if (!(dt > 0f))
                return;
            if (lists.Pack(group, 0).detail >= WingDetail.WavesOnly)
            {
                for (int k = 0; k < group.packCount; k++)
                    PackStep.Run(ref lists.Pack(group, k), scratch, dt);
                for (int k = 0; k < group.bodyCount; k++)
                    Follow(ref lists.Body(group, k), lists, dt);
                return;
            }

            int most = Plan(group, lists, dt, substeps);
            for (int k = 0; k < group.packCount; k++)
                PackStep.BeginStep(ref lists.Pack(group, k));
            for (int k = 0; k < group.bodyCount; k++)
                Begin(ref lists.Body(group, k));
            for (int step = 1; step <= most; step++)
            {
                for (int k = 0; k < group.bodyCount; k++)
                {
                    if (Takes(lists.Body(group, k), lists, step, out float h))
                        Prepare(ref lists.Body(group, k), lists, h);
                }

                for (int k = 0; k < group.packCount; k++)
                {
                    if (step <= PackStep.MostSubsteps(lists.Pack(group, k)))
                        PackStep.Substep(ref lists.Pack(group, k), scratch, step);
                }

                for (int k = 0; k < group.bodyCount; k++)
                {
                    if (Takes(lists.Body(group, k), lists, step, out float h))
                        Carry(ref lists.Body(group, k), lists, h);
                }
            }

            for (int k = 0; k < group.packCount; k++)
                PackStep.EndStep(lists.Pack(group, k));
            for (int k = 0; k < group.bodyCount; k++)
                End(ref lists.Body(group, k), lists);
        }

        // Substeps of all packs: wings that carry a body take as many as the one of them that needs most. Returns the largest number.
        private static int Plan(in PackGroup group, in GroupLists lists, float dt, int substeps)
        {
            for (int k = 0; k < group.packCount; k++)
            {
                ref WingPack pack = ref lists.Pack(group, k);
                PackStep.Plan(ref pack, dt);
                if (substeps == 0)
                    continue;
                pack.substeps = substeps;
                pack.substepLength = dt;
            }

            for (int k = 0; substeps == 0 && k < group.bodyCount; k++)
                lists.JoinSubsteps(lists.Body(group, k));
            int most = 1;
            for (int k = 0; k < group.packCount; k++)
                most = math.max(most, PackStep.MostSubsteps(lists.Pack(group, k)));
            return most;
        }

        // True where a body has a substep of this number, and how long it is.
        private static bool Takes(in FlyingBody body, in GroupLists lists, int step, out float h) => lists.Substeps(body, out h) >= step;

        private static void Begin(ref FlyingBody body)
        {
            body.force = body.moment = default;
            body.damping = default;
            body.aidPower = 0f;
            body.power = 0f;
        }

        private static void End(ref FlyingBody body, in GroupLists lists)
        {
            int count = lists.Substeps(body, out _);
            body.force /= count;
            body.moment /= count;
            body.damping = body.damping * (1f / count);
            body.aidPower /= count;
            body.power /= count;
        }

        // Before the wings' substep: the reference moves on, the feedback samples where the next beat is about to be latched, and the wings
        // are told what they meet.
        private static void Prepare(ref FlyingBody body, in GroupLists lists, float h)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            BeatState* beat = lists.Beat(body, out int lane);
            float phase = beat->phase[lane];
            bool due = phase + k_SampleAhead * beat->rate[lane] * h >= 2f * math.PI;
            body.sinceSample += h;
            if (body.mode == BodyMode.Held)
            {
                body.table.Read(body.reference.airSpeed, body.reference.climb, point);
                if (!due)
                    body.latched = 0;
                BodyMotion.Place(ref body, point, BodyBob.At(point, phase + 0.5f * h * beat->rate[lane]), body.reference.velocity);
                lists.MeetWake(body, point, BodyFeedback.Trim(point));
            }
            else if (body.mode == BodyMode.Free && body.follows > 1)
            {
                // Before Glide, which forgets it: the lead may span two substeps, and a beat that was counted twice has not settled.
                body.follows -= due && body.latched == 0 ? 1 : 0;
                Glide(ref body, lists, phase + 0.5f * h * beat->rate[lane], beat->rate[lane], h);
                body.latched = due ? 1 : 0;
            }
            else if (body.mode == BodyMode.Free)
            {
                if (body.follows != 0)
                {
                    body.follows = 0;
                    body.table.Read(body.reference.airSpeed, body.reference.climb, point);
                    BodyMotion.PlaceOnBob(ref body, point, phase, beat->rate[lane], body.velocity);
                }

                if (due && body.latched == 0)
                {
                    body.latched = 1;
                    body.beats++;
                    body.table.Read(body.reference.airSpeed, body.reference.climb, point);
                    if (body.steered != 0)
                        BodyFeedback.Sample(ref body, phase, point);
                    for (int k = 0; k < body.wingCount; k++)
                    {
                        lists.Command(
                            lists.wings[body.firstWing + k], BodyFeedback.Drive(body, point, lists.wings[body.firstWing + k].side));
                    }

                    lists.MeetWake(body, point, BodyFeedback.Drive(body, point, 0f));
                }
                else if (!due)
                {
                    body.latched = 0;
                }

                BodyAid.Evaluate(ref body, phase);
                BodyMotion.Predict(ref body, h);
            }

            else
            {
                body.middleRotation = body.rotation;
                body.middleVelocity = body.middleSpin = default;
                lists.MeetWake(body, null, default);
            }

            for (int k = 0; k < body.wingCount; k++)
                BodyAir.Surround(body, lists.wings[body.firstWing + k], lists.packs[lists.wings[body.firstWing + k].pack]);
        }

        // After the wings' substep: their forces move the body.
        private static void Carry(ref FlyingBody body, in GroupLists lists, float h)
        {
            BodyAir air = default;
            for (int k = 0; k < body.wingCount; k++)
                air.Add(lists.wings[body.firstWing + k], lists.packs[lists.wings[body.firstWing + k].pack]);
            body.power += air.power;
            bool flies = body.mode == BodyMode.Free && body.follows == 0;
            if (body.reacts != 0)
                React(ref body, lists, air, flies, h);
            else if (flies)
                BodyMotion.Step(ref body, air, h);
            else
                BodyMotion.Read(ref body, air);

            body.reference.velocity += h * body.reference.acceleration;
            body.reference.heading += h * body.reference.turning;
        }

        // The same of a body that the inertia of its wings moves.
        private static void React(ref FlyingBody body, in GroupLists lists, in BodyAir air, bool flies, float h)
        {
            BodyMasses now = body.hull;
            for (int k = 0; k < body.wingCount; k++)
                now.Add(lists.wings[body.firstWing + k], lists.packs[lists.wings[body.firstWing + k].pack]);
            BeatState* beat = lists.Beat(body, out int lane);
            body.abdomen.AddTo(ref now, beat->phase[lane], beat->rate[lane]);
            if (flies)
            {
                BodyReaction.Step(ref body, air, now, h);
                return;
            }

            BodyMotion.Read(ref body, air);
            if (body.mode != BodyMode.Held)
            {
                body.knowsMasses = 0;
                return;
            }

            float* point = stackalloc float[TrimPoint.Floats];
            body.table.Read(body.reference.airSpeed, body.reference.climb, point);
            BodyReaction.Hold(ref body, point, beat->phase[lane], h * beat->rate[lane], now, h);
        }

        // Far away and out of sight nobody computes the wings' forces.
        private static void Follow(ref FlyingBody body, in GroupLists lists, float dt)
        {
            if (body.mode != BodyMode.Free)
                return;
            BeatState* beat = lists.Beat(body, out int lane);
            Glide(ref body, lists, beat->phase[lane], beat->rate[lane], dt);
            body.reference.velocity += dt * body.reference.acceleration;
            body.reference.heading += dt * body.reference.turning;
            body.follows = k_SettledBeats + 1;
            body.latched = 1;
            body.knowsMasses = 0;
        }

        // The body follows its reference in the trimmed attitude with its bob, and the wings are commanded the trim's beat.
        private static void Glide(ref FlyingBody body, in GroupLists lists, float phase, float rate, float dt)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            body.table.Read(body.reference.airSpeed, body.reference.climb, point);
            float3 before = body.velocity, mean = math.lerp(before, body.reference.velocity, 1f - Elementary.Exp(-k_Following * dt));
            BodyMotion.PlaceOnBob(ref body, point, phase, rate, mean);
            body.velocity = mean;
            body.Move(dt * 0.5f * (before + mean));
            body.Forget();
            for (int k = 0; k < body.wingCount; k++)
                lists.Command(lists.wings[body.firstWing + k], BodyFeedback.Drive(body, point, lists.wings[body.firstWing + k].side));
            lists.MeetWake(body, point, BodyFeedback.Trim(point));
        }
    }
}
