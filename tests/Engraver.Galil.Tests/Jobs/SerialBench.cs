using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Links;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The bench over its serial port: the same bytes and byte times as on a terminal, without one.</summary>
internal static class SerialBench
{
    public static IControllerLink OpenSerialLink(this SimulatedBench bench, int baud) =>
        new StreamLink(bench.Controller.OpenSerialConnection(baud), "serial memory") { Line = new SerialLine(baud) };

    /// <param name="sending">Called with each line before it is sent.</param>
    /// <param name="harm">Returns the bytes that the controller receives instead of a line.</param>
    /// <param name="mend">Returns the bytes that the host receives instead of the sent ones.</param>
    public static Task<ControllerSession> OpenSerialAsync(this SimulatedBench bench, int baud, Action<string>? sending = null, Func<string, string>? harm = null, Func<string, string>? mend = null) => ControllerSession.OpenAsync(
        _ => Task.FromResult<IControllerLink>(new WithheldLink(bench.OpenSerialLink(baud)) { Sending = sending, Corrupt = harm, Repair = mend }),
        new SessionOptions(), bench.Clock, CancellationToken.None);

    public static async Task<JobResult> RunSerialAsync(
        this SimulatedBench bench, int baud, MotionProgram program, JobMode mode, IProgress<JobProgress>? progress = null, Action<string>? sending = null, CancellationToken stop = default)
    {
        await using var session = await bench.OpenSerialAsync(baud, sending);
        return await JobRunner.RunAsync(program, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, progress, stop);
    }
}
