using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Motion;

/// <summary>A family of controllers before one of them is connected: the limits of a machine, the conversion of a toolpath to motion, and its duration. A
/// connected controller is an <see cref="IMachineConnection"/> (ADR 9).</summary>
public interface IMachineDriver
{
    /// <summary>Name of the family.</summary>
    string Name { get; }

    /// <summary>The limits of a machine profile.</summary>
    MachineLimits Limits { get; }

    /// <summary>The times of a job that the host runs over a network: planned times and the playback show them while no other link is selected.</summary>
    CommandTimes NetworkTimes { get; }

    /// <summary>Converts a toolpath in millimetres to a motion program in counts.</summary>
    /// <param name="maxErrorMm">Maximum distance of chords from an arc that the controller cannot cut, millimetres, above 0.</param>
    /// <param name="sourceOf">Position of an entity in the drawing; diagnostics name it.</param>
    MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, double maxErrorMm, Func<int, SourceRef>? sourceOf, MotionStyle style);

    /// <summary>The program as it will be run over this link: where the link is too slow for its feed it is cut more slowly, and the finding reports
    /// it.</summary>
    /// <param name="address">Null for none: the feed is not limited.</param>
    LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, JobMode mode, Func<int, SourceRef>? sourceOf);

    /// <summary>Planned duration of the program over this link.</summary>
    /// <param name="program">Adapted to the link.</param>
    /// <param name="address">Null for none: as over a network.</param>
    MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, JobMode mode);
}
