using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>A simulated controller at full speed in this process or behind a socket or a pseudo-terminal, and its record compared with a drawing.</summary>
/// <remarks>The wall clock does not advance, and the host uses the controller's clock: runs do not depend on the speed of the computer.</remarks>
internal sealed class ServedController : IAsyncDisposable
{
    /// <summary>The fastest rate of the serial port: every byte still takes its time.</summary>
    private const int Baud = 115200;

    private readonly ManualTimeProvider _clock;
    private readonly DirectoryInfo _folder;
    private readonly SimulatedController? _controller;
    private readonly ControllerAddress _address;

    private ServedController(ManualTimeProvider clock, DirectoryInfo folder, SimulatedController? controller, ControllerAddress address)
    {
        _clock = clock;
        _folder = folder;
        _controller = controller;
        _address = address;
    }

    /// <param name="link">tcp, serial, or sim for a controller created and judged by the run.</param>
    public static async Task<ServedController> StartAsync(string link)
    {
        var clock = new ManualTimeProvider();
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        if (link == "sim") return new ServedController(clock, folder, null, new SimulatedAddress(double.PositiveInfinity));
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = clock });
        var address = link == "tcp" ? await ListenAsync(controller) : await ServeSerialAsync(controller, Path.Combine(folder.FullName, "tty"));
        Assert.True(ControllerAddress.TryParse(address, out var parsed));
        return new ServedController(clock, folder, controller, parsed);
    }

    /// <summary>Cuts the drawing over the link.</summary>
    public async Task<(JobResult Result, RunJudgement Judged)> CutAsync(string drawing, JobMode mode)
    {
        var job = JobPreparation.Prepare(DrawingFile.Open(drawing, new DrawingSettings(), CancellationToken.None), new DrawingSettings(), mode.Strategy().Style);
        var options = new MachineRunOptions(_address, mode.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl") };
        var program = JobPlan.FitToLink(job.Motion.Program!, _address, mode.Strategy(), job.Drawing).Program;
        var report = await MachineRun.RunAsync(job, program, options, _clock, null, CancellationToken.None);
        return (report.Result, _controller is { } served ? RecordJudgement.Of(job, served.Record.Snapshot(), 0, 0) : report.Judgement);
    }

    public async ValueTask DisposeAsync()
    {
        if (_controller is { } served) await served.DisposeAsync();
        _folder.Delete(recursive: true);
    }

    private static async Task<string> ListenAsync(SimulatedController controller)
    {
        var place = await controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{place.Port}?clock={clock.Port}");
    }

    private static async Task<string> ServeSerialAsync(SimulatedController controller, string path)
    {
        await controller.ServeSerialAsync(path, Baud, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        return string.Create(CultureInfo.InvariantCulture, $"serial://{path}?baud={Baud}&clock={clock.Port}");
    }
}
