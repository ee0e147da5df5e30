using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>Limits of the controller's commands, checked before a byte is sent (galil-dmc.md F.5 and B.1).</summary>
public static class DmcLimits
{
    /// <summary>Counts. Newer manuals allow 8,388,607; this is the smaller limit of the older ones.</summary>
    public const int LongestSegment = 8_000_000;

    /// <summary>The path length of one sequence must be below this, counts (TC 31).</summary>
    public const double LongestSequence = 2e9;

    /// <summary>Length of LI segments that may be buffered before BGS, counts (B.1).</summary>
    public const double LongestIncrements = 1L << 30;

    public const int SmallestRadius = 10;

    public const int LargestRadius = 6_000_000;

    /// <summary>Radius in counts times sweep in degrees must be below this.</summary>
    public const double RadiusTimesDegrees = 4.5e8;

    public const int SlowestSpeed = 2;

    /// <summary>VS and SP of servo axes, counts/s.</summary>
    public const int FastestSpeed = 12_000_000;

    /// <summary>VA, VD, AC and DC are multiples of this, counts/s2.</summary>
    public const int AccelerationStep = 1024;

    public const int LargestAcceleration = 67_107_840;

    /// <summary>Number of segments that the buffer of one plane holds.</summary>
    public const int SegmentBuffer = 511;

    public const int ProgramLines = 1000;

    public const int LineLength = 80;

    public const int Outputs = 8;

    /// <summary>Those of the limits that a machine profile can exceed.</summary>
    public static MachineLimits Machine { get; } = new(SlowestSpeed, FastestSpeed, AccelerationStep, LargestAcceleration, Outputs, DmcAxes.All)
    {
        MotorTypes = [1.0, -1.0, 1.5, -1.5, 2.0, -2.0, 2.5, -2.5],
        LargestVolts = 9.9982,
    };
}
