using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;

namespace Engraver.Galil.Driver;

/// <summary>The DMC family behind the machine seam; connected it is a <see cref="GalilConnection"/>.</summary>
public sealed class GalilDriver : IMachineDriver
{
    public string Name => "Galil DMC-21x3";

    public MachineLimits Limits => DmcLimits.Machine;

    public CommandTimes NetworkTimes => DmcTimes.Ethernet;

    public MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, double maxErrorMm, Func<int, SourceRef>? sourceOf, MotionStyle style) =>
        MotionProgramGenerator.Generate(toolpath, profile, maxErrorMm, sourceOf, style);

    public LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, JobMode mode, Func<int, SourceRef>? sourceOf) => (LineOf(address), mode) is ({ } line, JobMode.Stream)
        ? LinkFeedFitting.Create(program, line, sourceOf)
        : new LinkFeedFit(program, []);

    public MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, JobMode mode) => JobTime.Estimate(program, LineOf(address), mode);

    private static SerialLine? LineOf(ControllerAddress? address) => address is SerialAddress serial ? new SerialLine(serial.Baud) : null;
}
