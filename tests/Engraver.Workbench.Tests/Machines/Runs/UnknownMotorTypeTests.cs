using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>A controller without the operand of the motor type (_MT), and a profile without it.</summary>
public sealed class UnknownMotorTypeTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData(false, "X, Y", "XY")]
    [InlineData(true, null, "")]
    public async Task A_run_warns_of_motors_whose_type_nobody_tells_and_takes_them_for_steppers(bool isKnown, string? untold, string openLoop)
    {
        var told = new List<Diagnostic>();
        var report = await RunAsync(isKnown, told.Add);

        Assert.True(report.Result.Outcome == JobOutcome.Complete, report.Result.Message);
        Assert.Equal(untold, told.SingleOrDefault(diagnostic => diagnostic.Rule == PreparationRules.MotorUntold)?.Facts[0]);
        Assert.Equal(openLoop, string.Concat(report.OpenLoop));
    }

    private async Task<MachineRunReport> RunAsync(bool isKnown, Action<Diagnostic> told)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new ManualTimeProvider() });
        IControllerLink Link() => new StreamLink(controller.OpenConnection(), "memory");
        await using var connection = MachineConnection.FromLink("memory", _ => Task.FromResult(isKnown ? Link() : new MotorQuestionLink(Link())), () => MachineClock.FromSimulator(controller.JoinClock()));
        var settings = new DrawingSettings();
        var job = JobPreparation.Prepare(DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, "paper-001.dxf"), settings, CancellationToken.None), settings, MotionStyle.Continuous);
        var options = new MachineRunOptions(new TcpAddress("memory", 1), JobMode.Stream.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl"), FindingReported = told };
        return await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, null, CancellationToken.None);
    }

    /// <summary>Replaces queries of the motor type by an unknown operand.</summary>
    private sealed class MotorQuestionLink(IControllerLink inner) : IControllerLink
    {
        public string Description => inner.Description;

        public SerialLine? Line => inner.Line;

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) =>
            inner.WriteAsync(System.Text.Encoding.Latin1.GetBytes(System.Text.Encoding.Latin1.GetString(bytes.Span).Replace("_MT", "_QQ", StringComparison.Ordinal)), cancellation);

        public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => inner.ReadAsync(buffer, cancellation);

        public ValueTask DisposeAsync() => inner.DisposeAsync();
    }
}
