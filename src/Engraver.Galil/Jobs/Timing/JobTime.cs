using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Timing;

namespace Engraver.Galil.Jobs.Timing;

/// <summary>Planned time of a job on a link of this kind and in this mode: <see cref="MotionTime"/> with the command times of both.</summary>
public static class JobTime
{
    /// <param name="program">As it will be run, with feeds lowered for the line (<see cref="LinkFeedFit"/>).</param>
    /// <param name="line">The serial line; null for a network or the simulated controller.</param>
    public static MotionTimes Estimate(MotionProgram program, SerialLine? line, JobMode mode) => MotionTime.Calculate(program, Commands(line, mode));

    /// <param name="line">As for <see cref="Estimate"/>.</param>
    public static CommandTimes Commands(SerialLine? line, JobMode mode) => (line, mode) switch
    {
        (_, JobMode.Program) => new ProgramTimes(line),
        (null, _) => DmcTimes.Ethernet,
        _ => new SerialTimes(line),
    };
}
