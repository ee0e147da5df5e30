using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Motion;

/// <summary>A family of controllers before one of it is connected: what a machine may be, how a toolpath becomes motion for it, how long that takes. Connected it is an <see cref="IMachineConnection"/> (ADR 9).</summary>
public interface IMachineDriver
{
    /// <summary>Of the family.</summary>
    string Name { get; }

    /// <summary>What a machine profile may hold.</summary>
    MachineLimits Limits { get; }

    /// <summary>How time passes in a job that the host leads over a network: what planned times and the playback show while no other link is chosen.</summary>
    CommandTimes NetworkTimes { get; }

    /// <summary>Toolpath in millimetres to motion program in counts.</summary>
    /// <param name="maxErrorMm">How far chords may leave an arc that the controller cannot cut, millimetres, above 0.</param>
    /// <param name="sourceOf">Where an entity stands in the drawing; diagnostics name it.</param>
    MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, double maxErrorMm, Func<int, SourceRef>? sourceOf, MotionStyle style);

    /// <summary>The program as it will be run over this link: where the link is too slow for its feed it is cut slower, and the finding says so.</summary>
    /// <param name="address">Null for none: nothing limits the feed.</param>
    LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, JobMode mode, Func<int, SourceRef>? sourceOf);

    /// <summary>How long the program will take over this link.</summary>
    /// <param name="program">Made fit for the link.</param>
    /// <param name="address">Null for none: as over a network.</param>
    MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, JobMode mode);
}
