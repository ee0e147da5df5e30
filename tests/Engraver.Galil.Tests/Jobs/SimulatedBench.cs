using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.Simulator.Clocks;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A simulated controller at full speed and the connections to it.</summary>
internal sealed class SimulatedBench : IAsyncDisposable
{
    public static readonly JobOptions Job = new();

    private HostClock? _clock;

    /// <param name="clock">The controller's wall clock: with one that does not advance, silence of the host lets no time pass, independent of delays of this
    /// computer.</param>
    /// <param name="spacing">The separator before a negative number.</param>
    /// <param name="lag">Lag of the motors behind their commands.</param>
    /// <param name="model">The reply to ^R^V; null for the usual one.</param>
    /// <param name="serialNumber">What _BN answers; null: each controller has its own.</param>
    public SimulatedBench(FaultPlan? faults = null, int programLines = 1000, TimeProvider? clock = null, NumberSpacing spacing = NumberSpacing.Blank, TimeSpan lag = default, string? model = null, int? serialNumber = null, params AxisSwitches[] switches) => Controller = new SimulatedController(
        new SimulatorOptions { Speed = double.PositiveInfinity, Faults = faults, ProgramLines = programLines, Time = clock ?? TimeProvider.System, NumberSpacing = spacing, ServoLag = lag, Switches = switches, Model = model ?? new SimulatorOptions().Model, SerialNumber = serialNumber ?? new SimulatorOptions().SerialNumber });

    public SimulatedController Controller { get; }

    public MotionSample Last => Controller.Record[Controller.Record.Count - 1];

    /// <summary>The controller's clock, which the bench's sessions use; acquired with the first of them.</summary>
    public HostClock Clock => _clock ??= Controller.JoinClock();

    /// <summary>The host is lost: time advances without it.</summary>
    public void ReleaseClock()
    {
        _clock?.Dispose();
        _clock = null;
    }

    /// <param name="opened">Called with each opened link: the command handle, then the second one.</param>
    public Task<ControllerSession> OpenAsync(Action<WithheldLink>? opened = null) => ControllerSession.OpenAsync(
        _ =>
        {
            var link = new WithheldLink(new StreamLink(Controller.OpenConnection(), "memory"));
            opened?.Invoke(link);
            return Task.FromResult<IControllerLink>(link);
        },
        new SessionOptions(),
        Clock,
        CancellationToken.None);

    public async Task<ControllerSession> OpenTcpAsync()
    {
        var end = await Controller.ListenTcpAsync(0, CancellationToken.None);
        return await ControllerSession.OpenAsync(
            async cancellation => await TcpLink.ConnectAsync("127.0.0.1", end.Port, TimeSpan.FromSeconds(60), TimeProvider.System, cancellation),
            new SessionOptions { ReplyTimeout = TimeSpan.FromSeconds(60) }, Clock, CancellationToken.None);
    }

    /// <summary>Runs a job and closes the session after it.</summary>
    public async Task<JobResult> RunAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress = null, CancellationToken stop = default)
    {
        await using var session = await OpenAsync();
        return await JobRunner.RunAsync(program, session, options, progress, stop);
    }

    /// <summary>Everything that a job may change, queried over a separate connection.</summary>
    public async Task<string> FingerprintAsync()
    {
        string[] questions =
        [
            "_CF", "_CW", "_DR0", "_VF", "_VSS", "_VAS", "_VDS", "_VRS", "_OP0", "_NO", "_CA", "_VRS{$8.4}",
            .. "ABCD".SelectMany(axis => new[] { "_SP", "_AC", "_DC", "_MO" }.Select(name => name + axis)),
        ];
        await using var channel = OpenChannel();
        var answers = new List<string>();
        foreach (var question in questions) answers.Add($"{question} {await channel.SendAsync("MG " + question, CancellationToken.None)}");
        answers.Add($"UL {await channel.UploadAsync(CancellationToken.None)}");
        return string.Join('\n', answers);
    }

    /// <summary>The present VF, with one decimal.</summary>
    public Task<string> NumberFormatAsync() => AskAsync("_VF{F3.1}");

    /// <summary>A number with up to four decimals, independent of VF.</summary>
    public async Task<string> NumberAsync(string operand)
    {
        await using var channel = OpenChannel();
        return DmcFormat.Number((await channel.ReadAsync(operand + "{F10.4}", CancellationToken.None)).Values[0]);
    }

    /// <summary>A whole number, independent of VF.</summary>
    public Task<string> WholeAsync(string operand) => AskAsync(operand + "{F10.0}");

    private async Task<string> AskAsync(string operand)
    {
        await using var channel = OpenChannel();
        var answer = Assert.IsType<Accepted>(await channel.SendAsync("MG " + operand, CancellationToken.None)).Data.Trim();
        return answer is ['-', .. var digits] ? "-" + digits.TrimStart('0') : answer.TrimStart('0');
    }

    /// <summary>Sends commands as another host would, before or beside the session.</summary>
    public async Task SendAsync(params string[] commands)
    {
        await using var channel = OpenChannel();
        foreach (var command in commands) Assert.IsType<Accepted>(await channel.SendAsync(command, CancellationToken.None));
    }

    /// <summary>The same in the middle of a job, from code that cannot wait; the replies are ignored.</summary>
    public void Interfere(string command)
    {
        using var stream = Controller.OpenConnection();
        stream.Write(Encoding.Latin1.GetBytes(command + "\r"));
    }

    public async Task DownloadAsync(string program)
    {
        await using var channel = OpenChannel();
        Assert.IsType<Accepted>(await channel.DownloadAsync(program, CancellationToken.None));
    }

    private CommandChannel OpenChannel() => new(new StreamLink(Controller.OpenConnection(), "memory"), "F", TimeSpan.FromSeconds(60), TimeProvider.System, null);

    public ValueTask DisposeAsync() => Controller.DisposeAsync();
}
