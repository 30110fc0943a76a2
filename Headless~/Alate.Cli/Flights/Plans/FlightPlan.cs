using Alate.Benchmarks;

namespace Alate.Cli;

/// <summary>Plan of a flight: the insect, its flight, the model, and the folder of the files.</summary>
internal sealed record FlightPlan
{
    private readonly string m_Species;
    private readonly InsectDefinition m_Definition;

    /// <summary>Name of the insect whose numbers fly.</summary>
    public string Species
    {
        get => m_Species;
        init => (m_Species, m_Definition) = (value, null);
    }

    /// <summary>The insect whose numbers fly: of the catalogue by its name, or of an insect file.</summary>
    /// <exception cref="UserException">The catalogue has no insect of that name.</exception>
    public InsectDefinition Definition
    {
        get => m_Definition ?? KnownSpecies.FindInCatalogue(Species);
        init => (m_Species, m_Definition) = (value?.Name, value);
    }

    /// <summary>Wing of the user's own, and its skeleton; null for the species'.</summary>
    public string MeshFile { get; init; }
    public string SkeletonFile { get; init; }

    /// <summary>Picture for its texture coordinates; null is that of its material, if it has one.</summary>
    public string TextureFile { get; init; }

    /// <summary>The same of a hind wing; null for none.</summary>
    public string HindMeshFile { get; init; }
    public string HindSkeletonFile { get; init; }
    public string HindTextureFile { get; init; }

    /// <summary>Kinds of wings that are the user's own.</summary>
    public int OwnWings => HindMeshFile != null ? 2 : MeshFile != null ? 1 : 0;

    /// <summary>File with a motion to prescribe; null for none.</summary>
    public string KinematicsFile { get; init; }

    /// <summary>Speed of the body ahead and up, m/s.</summary>
    public double Speed { get; init; } = 1.3;
    public double Climb { get; init; }

    /// <summary>Nose up positive.</summary>
    public double PitchDegrees { get; init; }

    /// <summary>Time of the flight; null is eight beats. A shorter one begins when the beat has settled.</summary>
    public double? Seconds { get; init; }

    /// <summary>Velocity of the air over ground, m/s: right, up, ahead.</summary>
    public double[] Wind { get; init; } = [0, 0, 0];

    /// <summary>Air that the wings draw along; null for none.</summary>
    public InducedFlow Induced { get; init; }

    /// <summary>Air that the wake sets moving; null for none.</summary>
    public FlightInflow Inflow { get; init; }

    /// <summary>True where the air that the wings carry along across their surface counts.</summary>
    public bool AddedMass { get; init; }

    /// <summary>λ; null is the species'.</summary>
    public double? Lag { get; init; }

    /// <summary>Factor on the species' k_e.</summary>
    public double Elasticity { get; init; } = 1;

    /// <summary>Factor on all amplitudes of the beat, 0 to 2.</summary>
    public double Amplitude { get; init; } = 1;

    /// <summary>Factor on the frequency of the beat; the wing stays as stiff as it is.</summary>
    public double Frequency { get; init; } = 1;
    public int? Substeps { get; init; }

    /// <summary>0 is one per triangle.</summary>
    public int Patches { get; init; } = WingRigSettings.Default.patchCount;
    public CoefficientSet? Coefficients { get; init; }
    public ModelReading Preset { get; init; }

    /// <summary>Scheme by which time advances; null is the preset's.</summary>
    public TimeScheme? TimeScheme { get; init; }

    /// <summary>True where the model is version 0.1's; see <see cref="AsVersion01"/>.</summary>
    public bool IsVersion01 { get; init; }
    public InsectVariant Variant { get; init; }

    /// <summary>A beat in place of the one that follows the speed; null is that one.</summary>
    public WingDrive? Drive { get; init; }

    /// <summary>A number of the species at another value; null changes none.</summary>
    public ParameterChange Change { get; init; }

    /// <summary>True where frames have the air's loads on joints and strips and its angle of attack.</summary>
    public bool RecordsAir { get; init; }

    /// <summary>Joints that do not bend: what is left is the drive with its wave.</summary>
    public bool HoldJoints { get; init; }

    /// <summary>Column of the model: the parts that are left out.</summary>
    public ComparisonColumn Column { get; init; } = ComparisonColumn.FullModel;

    /// <summary>The side from which the pictures show the insect.</summary>
    public PictureView View { get; init; } = PictureView.FrontLeft;

    /// <summary>True where pictures are written.</summary>
    public bool IsDrawn { get; init; } = true;

    /// <summary>Record of the run, so that it can be flown again; null for none.</summary>
    public RunRecord Record { get; init; }

    /// <summary>Null is out/SPECIES.</summary>
    public string Folder { get; init; }

    /// <summary>|u| of Eq. 6–7, m/s.</summary>
    public double BodySpeed => Math.Sqrt(Speed * Speed + Climb * Climb);

    /// <summary>The speed ahead of a species that is not told any, m/s: 0.65 of its top speed, 1.3 for every insect.</summary>
    public static double CruiseOf(InsectDefinition definition)
    {
        const double k_Share = 0.65;
        WingPreset preset = definition.Wings[0].CreatePreset();
        double cruise = Math.Round(k_Share * preset.Beat.maxSpeed, 3);
        UnityEngine.Object.DestroyImmediate(preset);
        return cruise;
    }

    /// <summary>Level flight of a species at <see cref="CruiseOf"/>.</summary>
    public static FlightPlan Cruise(InsectDefinition definition, InsectVariant variant) =>
        new() { Definition = definition, Variant = variant, Speed = CruiseOf(definition) };

    /// <summary>The species' parameters with this plan's changes.</summary>
    /// <exception cref="UserException">They leave the range that the model takes.</exception>
    public WingParameters ParametersOf(WingPreset preset)
    {
        WingPreset shown = Column.CreatePreset(preset);
        WingParameters parameters = shown.ToParameters();
        UnityEngine.Object.DestroyImmediate(shown);
        parameters.elasticity *= (float)Elasticity;
        parameters.amplitudeScale *= (float)Amplitude;
        parameters.maxFrequency *= (float)Frequency;
        parameters.substepsPerBeat = Substeps ?? parameters.substepsPerBeat;
        parameters.chordDelay = (float)(Lag ?? parameters.chordDelay);
        parameters.options.addedMass |= AddedMass;
        parameters.options.coefficients = Coefficients ?? parameters.options.coefficients;
        if (IsVersion01)
            Version01.ApplyTo(ref parameters);
        parameters.options.timeScheme = TimeScheme ?? parameters.options.timeScheme;
        if (HoldJoints)
            parameters.jointLimit = 0f;
        string problem = parameters.FindProblem();
        return problem == null ? parameters : throw new UserException(problem);
    }

    /// <summary>Parameters of a wing on one side, with the air that its wake sets moving.</summary>
    /// <exception cref="UserException">They leave the range that the model takes.</exception>
    public WingParameters ParametersOf(WingPreset preset, string name, WingSide side)
    {
        WingParameters parameters = ParametersOf(preset);
        parameters.inflow = Inflow?.Of(name, side, preset.WingLength) ?? default;
        return parameters;
    }

    /// <summary>Returns this flight by version 0.1 at its defaults.</summary>
    public FlightPlan AsVersion01() => this with
    {
        IsVersion01 = true,
        Substeps = Variant == InsectVariant.Expressive ? Version01.SoftSubsteps : Version01.Substeps,
        Patches = Version01.Patches,
    };

    /// <summary>
    /// Surroundings of a wing of a body in this flight, in the frame of its right wing or mirrored into that of its left one.
    /// </summary>
    public WingSurroundings SurroundingsOf(WingPreset preset, WingSide side)
    {
        float pitch = math.radians((float)PitchDegrees);
        float3 air = AirPastBody;
        air.x = side == WingSide.Right ? air.x : -air.x;
        return new WingSurroundings
        {
            wind = ToBody(air, pitch) / preset.WingLength,
            gravity = ToBody(EarthGravity.Down, pitch) * (preset.Size.gravityShare / preset.WingLength),
            speed = (float)BodySpeed,
            angleOfAttack = pitch,
        };
    }

    /// <summary>The world's up as the body sees it.</summary>
    public float3 UpOfBody => ToBody(new float3(0f, 1f, 0f), math.radians((float)PitchDegrees));

    /// <summary>Direction of the flight as the body sees it; zero on the spot.</summary>
    public float3 WayOfBody => ToBody(math.normalizesafe(new float3(0f, (float)Climb, (float)Speed)));

    /// <summary>Velocity of the air against the body along the world's axes, m/s: right, up, ahead.</summary>
    public float3 AirPastBody => new((float)Wind[0], (float)(Wind[1] - Climb), (float)(Wind[2] - Speed));

    /// <summary>Velocity of the air against the body, in axes of the body, m/s.</summary>
    public float3 AirInBodyAxes => ToBody(AirPastBody, math.radians((float)PitchDegrees));

    /// <summary>A direction of the world as the body sees it.</summary>
    public float3 ToBody(float3 world) => ToBody(world, math.radians((float)PitchDegrees));

    /// <summary>A direction of the body as the world sees it.</summary>
    public float3 ToWorld(float3 body) => ToBody(body, -math.radians((float)PitchDegrees));

    private static float3 ToBody(float3 world, float pitch)
    {
        math.sincos(pitch, out float sine, out float cosine);
        return new float3(world.x, cosine * world.y - sine * world.z, sine * world.y + cosine * world.z);
    }
}
