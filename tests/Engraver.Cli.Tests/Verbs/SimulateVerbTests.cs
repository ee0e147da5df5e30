using System.Globalization;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.Cli.Tests.Verbs;

public class SimulateVerbTests
{
    [Theory]
    [InlineData(PosixSignal.SIGINT)]
    [InlineData(PosixSignal.SIGTERM)]
    public async Task It_serves_until_a_signal_and_then_ends_with_exit_0(PosixSignal signal)
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate");

        Assert.Matches("^listening tcp://127\\.0\\.0\\.1:[0-9]+$", await simulate.LineAsync("listening ", patience.Token));
        simulate.Signal(signal);
        await simulate.WaitAsync(patience.Token);
        Assert.Equal(ExitCode.Done, simulate.ExitCode);
    }

    /// <summary>Regression: the file was closed before the controller that writes it had ended, which aborted half of the runs.</summary>
    [Fact]
    public async Task A_signal_while_something_moves_completes_the_record_and_is_exit_0()
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--record", folder.PathOf("record.csv"));
        using var client = new TcpClient("127.0.0.1", PortOf(await simulate.LineAsync("listening ", patience.Token)));
        Assert.Equal("::", await AskAsync(client, "JG 1000;BGA\r", patience.Token, prompts: 2));
        while ((await AskAsync(client, "MG _RPA\r", patience.Token)).StartsWith(" 0.", StringComparison.Ordinal)) patience.Token.ThrowIfCancellationRequested();

        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        Assert.Equal((ExitCode.Done, ""), (simulate.ExitCode, await simulate.Error.ReadToEndAsync(patience.Token)));
        Assert.Matches("\n[0-9.]+,[1-9][0-9]*,0,0,0,0\n$", await File.ReadAllTextAsync(folder.PathOf("record.csv"), patience.Token));
    }

    [Fact]
    public async Task An_interrupt_reaches_a_simulator_that_a_script_started_in_the_background()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.StartInBackground("simulate", "--tcp", "0", "--speed", "max");

        await simulate.LineAsync("listening ", patience.Token);
        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);
        Assert.Equal(ExitCode.Done, simulate.ExitCode);
    }

    [Fact]
    public async Task Two_clients_by_TCP_and_one_by_datagram_talk_to_the_same_controller()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate", "--tcp", "0", "--udp", "0", "--speed", "max");
        var port = PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token));
        var datagrams = PortOf(await simulate.LineAsync("listening udp://127.0.0.1:", patience.Token));
        using var first = new TcpClient("127.0.0.1", port);
        using var second = new TcpClient("127.0.0.1", port);
        using var third = new UdpClient();
        third.Connect("127.0.0.1", datagrams);

        Assert.Equal(":", await AskAsync(first, "n=41\r", patience.Token));
        Assert.Equal(":", await AskAsync(second, "n=n+1\r", patience.Token));
        await third.SendAsync("MG n\r"u8.ToArray(), patience.Token);
        Assert.Equal(" 42.0000\r\n:", Encoding.ASCII.GetString((await third.ReceiveAsync(patience.Token)).Buffer));
    }

    [Fact]
    public async Task A_signal_that_comes_before_everything_is_served_is_exit_0_too()
    {
        using var early = new CancellationTokenSource();
        await early.CancelAsync();
        var run = await CliRun.RunAsync(early.Token, "simulate");

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
    }

    [Fact]
    public async Task A_faults_file_makes_the_controller_refuse_what_it_says()
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate", "--speed", "max", "--faults", folder.WithFile("faults.json", """{"refusals":[{"command":2,"tcCode":32}]}"""));
        using var client = new TcpClient("127.0.0.1", PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token)));

        Assert.Equal(":", await AskAsync(client, "n=1\r", patience.Token));
        Assert.Equal("?", await AskAsync(client, "n=2\r", patience.Token));
        Assert.StartsWith("32 ", await AskAsync(client, "TC1\r", patience.Token), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_bug_of_the_simulator_is_exit_70_with_a_report_and_no_client_waits_for_ever()
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate", "--speed", "max", "--faults", folder.WithFile("faults.json", """{"breakDownAtCommand":2}"""));
        var port = PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token));
        using var client = new TcpClient("127.0.0.1", port);
        using var other = new TcpClient("127.0.0.1", port);
        Assert.Equal(":", await AskAsync(client, "n=1\r", patience.Token));

        await client.GetStream().WriteAsync("n=2\r"u8.ToArray(), patience.Token);

        await Assert.ThrowsAnyAsync<IOException>(() => other.GetStream().ReadExactlyAsync(new byte[1], patience.Token).AsTask());
        await simulate.WaitAsync(patience.Token);
        var said = await simulate.Error.ReadToEndAsync(patience.Token);
        Assert.Equal(ExitCode.InternalError, simulate.ExitCode);
        var report = Assert.Single(System.Text.RegularExpressions.Regex.Matches(said, "[^ ]+engraver-crash-[^ ;]+\\.txt")).Value;
        Assert.Contains("The fault plan makes the simulator fail", await File.ReadAllTextAsync(report, patience.Token), StringComparison.Ordinal);
        Assert.Contains("every client was cut off", said, StringComparison.Ordinal);
        File.Delete(report);
    }

    [Fact]
    public async Task A_faults_file_that_is_not_there_is_exit_2_with_one_sentence()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("simulate", "--faults", folder.PathOf("missing.json"));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--faults", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
    }

    /// <summary>Regression: each was a message of the JSON reader with type names and without the offending name.</summary>
    [Theory]
    [InlineData("""{"refusals":null}""", 1, "FLT0003", "refusals in the fault file is not valid; it must be a list")]
    [InlineData("""{"drops":[null]}""", 1, "FLT0003", "drops[0] in the fault file is not valid; it must be an object")]
    [InlineData("""{"refusal":[]}""", 1, "FLT0002", "the unknown field refusal; the nearest known name is refusals")]
    [InlineData("{\n  \"faults\": [\n    { \"kind\": \"jam\", \"atsecond\": 1 }\n  ]\n}", 3, "FLT0002", "the unknown field faults[0].atsecond; the nearest known name is atSeconds")]
    [InlineData("{\n  \"faults\": [\n    { \"kind\": \"limitswitch2\", \"atSeconds\": 1 }\n  ]\n}", 3, "FLT0003", "powerCycle; the nearest known name is limitSwitch")]
    [InlineData("{\n  \"faults\": [\n    { \"kind\": \"jam\",\n      \"atSeconds\": \"soon\" }\n  ]\n}", 4, "FLT0003", "faults[0].atSeconds in the fault file is not valid; it must be a number")]
    [InlineData("{\n  \"faults\": [\n    { \"atSeconds\": 1 }\n  ]\n}", 3, "FLT0004", "faults[0] is not possible: kind is missing")]
    [InlineData("{\n  \"faults\": [\n    { \"kind\": \"jam\",\n      \"atSeconds\": 1 }\n  ]\n}", 3, "FLT0004", "a fault of kind jam needs an axis")]
    [InlineData("{\n  \"replyDelay\": 50\n}", 2, "FLT0003", "replyDelay in the fault file is not valid; it must be a time as text")]
    [InlineData("no JSON", 1, "FLT0001", "not valid JSON")]
    [InlineData("null", 1, "FLT0001", "not a JSON object")]
    [InlineData("[1]", 1, "FLT0001", "not a JSON object")]
    public async Task What_is_wrong_in_a_faults_file_is_told_with_its_line_and_what_was_meant(string content, int line, string id, string sentence)
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("faults.json", content);
        var run = await CliRun.RunAsync("simulate", "--faults", file);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.StartsWith($"{file}({line}): error {id}: ", run.Error, StringComparison.Ordinal);
        Assert.Contains(sentence, run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_machine_profile_stands_in_the_controller_as_if_it_were_burned()
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        var profile = folder.WithFile("machine.json", """{"countsPerMillimetreX":500,"feedMmPerMinute":300,"rapidMmPerMinute":600,"accelerationCounts":102400,"angleQuantumDegrees":0.5}""");
        using var simulate = EngraverProcess.Start("simulate", "--speed", "max", "--machine", profile);
        using var client = new TcpClient("127.0.0.1", PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token)));

        Assert.Equal(" 5000.0000 10000.0000 25000.0000 2500.0000\r\n:", await AskAsync(client, "MG _SPA,_SPB,_SPC,_VSS\r", patience.Token));
        Assert.Equal(" 102400.0000 102400.0000 102400.0000 102400.0000\r\n:", await AskAsync(client, "MG _ACA,_DCB,_VAS,_VDT\r", patience.Token));
    }

    [Fact]
    public async Task Each_command_takes_the_decode_time_before_its_prompt()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start("simulate", "--speed", "max", "--decode", "2.5");
        using var client = new TcpClient("127.0.0.1", PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token)));

        for (var i = 0; i < 10; i++) Assert.Equal("::", await AskAsync(client, "x=1;x=2\r", patience.Token, prompts: 2));

        // 21 times 2.5 s, and 1.6 ms each for the first 20.
        Assert.Equal(" 52532.0000\r\n:", await AskAsync(client, "MG TIME\r", patience.Token));
    }

    [Theory]
    [InlineData(null, 20_000, 4000)]
    [InlineData("--early-ramps", 4000, 4000)]
    [InlineData("--one-pending-exit", 20_000, 20_000)]
    [InlineData("--own-entry-speed", 10_000, 4000)]
    public async Task The_other_readings_of_speeds_at_segments_are_options(string? option, double inSecond, double atCorner)
    {
        using var folder = new TemporaryFolder();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var simulate = EngraverProcess.Start(["simulate", "--speed", "max", "--record", folder.PathOf("record.csv"), .. option is null ? [] : new[] { option }]);
        using (var client = new TcpClient("127.0.0.1", PortOf(await simulate.LineAsync("listening tcp://127.0.0.1:", patience.Token))))
        {
            foreach (var line in (string[])["VMAB", "VS 10000", "VP 20000,0<20000", "VP 40000,0>4000", "VP 60000,0>4000", "VP 80000,0", "VE", "BGS"]) await AskAsync(client, line + "\r", patience.Token);
            while (!(await AskAsync(client, "MG _BGS\r", patience.Token)).StartsWith(" 0.", StringComparison.Ordinal)) patience.Token.ThrowIfCancellationRequested();
        }

        simulate.Signal(PosixSignal.SIGINT);
        await simulate.WaitAsync(patience.Token);

        var places = (await File.ReadAllLinesAsync(folder.PathOf("record.csv"), patience.Token)).Skip(1).Select(row => int.Parse(row.Split(',')[1], CultureInfo.InvariantCulture)).ToList();
        Assert.Equal(inSecond, SpeedBefore(30_000), 200.0);
        Assert.Equal(atCorner, SpeedBefore(60_000), 2000.0);

        double SpeedBefore(int place)
        {
            var there = places.FindIndex(a => a >= place);
            return (places[there] - places[there - 10]) * 100.0;
        }
    }

    [Fact]
    public async Task A_machine_profile_that_cannot_be_used_is_exit_2_with_one_sentence()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("simulate", "--machine", folder.WithFile("machine.json", """{"toolOutput":9}"""));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("toolOutput", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_port_that_is_none_is_told_by_the_name_of_its_option()
    {
        var run = await CliRun.RunAsync("simulate", "--udp", "65536");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--udp: '65536' is not a port", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_port_that_is_taken_is_exit_4_with_one_sentence()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        using var first = EngraverProcess.Start("simulate");
        var port = (await first.LineAsync("listening ", patience.Token)).Split(':')[^1];
        var second = await CliRun.RunAsync("simulate", "--tcp", port);

        Assert.Equal(ExitCode.LinkLost, second.ExitCode);
        Assert.Single(second.Error.TrimEnd().Split('\n'));
    }

    private static int PortOf(string line) => int.Parse(line.Split(':')[^1], CultureInfo.InvariantCulture);

    private static async Task<string> AskAsync(TcpClient client, string command, CancellationToken cancellation, int prompts = 1)
    {
        await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(command), cancellation);
        var (reply, length) = (new byte[256], 0);
        do
        {
            var read = await client.GetStream().ReadAsync(reply.AsMemory(length), cancellation);
            Assert.NotEqual(0, read);
            length += read;
        }
        while (reply[length - 1] is not ((byte)':' or (byte)'?') || length < prompts); // an answer may come in parts, its prompt is last
        return Encoding.ASCII.GetString(reply, 0, length);
    }
}
