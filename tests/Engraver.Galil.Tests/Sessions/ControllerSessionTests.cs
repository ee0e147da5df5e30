using Engraver.Core.Machines;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Jobs;
using Engraver.Galil.Tests.Links;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Sessions;

public class ControllerSessionTests
{
    [Fact]
    public async Task The_controller_says_who_it_is_and_what_it_has()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();

        var identity = session.Identity;

        Assert.Equal(("DMC2143 Rev 1.0o", 4, "ABCD", "IHA", 156), (identity.Model, identity.Axes, identity.Letters, identity.Handle, identity.RecordBytes));
        Assert.Equal((511, 1000, 6), (identity.Limits.Segments, identity.Limits.SampleMicroseconds, identity.Limits.FreeHandles));
    }

    /// <summary>The digit of the axes is the third of four or the fourth of five.</summary>
    [Theory]
    [InlineData("DMC2143 Rev 1.0o", 4, "DMC-21x3", true)]
    [InlineData("DMC2143...", 4, "DMC-21x3", true)]
    [InlineData("DMC2182s87j", 8, "DMC-21x2", true)]
    [InlineData("DMC4143", 4, "DMC-41x3", false)]
    [InlineData("DMC4143 Rev 1.2", 4, "DMC-41x3", false)]
    [InlineData("DMC4080 Rev 1.0i", 8, "DMC-40x0", false)]
    [InlineData("DMC50040 Rev 1.0", 4, "DMC-500x0", false)]
    [InlineData("DMC52040", 4, "DMC-520x0", false)]
    [InlineData("DMC30010 Rev 1.2d", 1, "DMC-300x0", false)]
    [InlineData("DMC1842", 4, "DMC-18x2", false)]
    [InlineData("DMC1846", 4, "DMC-18x6", false)]
    [InlineData("DMC9929 Rev 9", 2, "DMC-99x9", false)]
    public void Family_and_axes_are_read_from_the_model(string model, int axes, string family, bool isSimulated) =>
        Assert.Equal(new ControllerModel(axes, family, isSimulated), ControllerModel.Parse(model));

    [Theory]
    [InlineData("RIO47100")]
    [InlineData("HTTP/1.1 400")]
    [InlineData("DMC")]
    [InlineData("DMC500")]
    [InlineData("DMC2103")]
    [InlineData("DMC214300")]
    public void What_names_no_model_of_the_family_is_none(string answer) => Assert.Null(ControllerModel.Parse(answer));

    [Fact]
    public async Task A_controller_with_one_axis_is_refused_with_what_is_needed()
    {
        await using var bench = new SimulatedBench(model: "DMC30010 Rev 1.2d");

        var refused = await Assert.ThrowsAsync<ProtocolViolationException>(() => bench.OpenAsync());

        Assert.Equal("DMC30010 Rev 1.2d has one axis; a drawing needs two. Connect a controller with two or more axes.", refused.Message);
    }

    [Theory]
    [InlineData("DMC2123 Rev 1.0o", null)]
    [InlineData("DMC4143 Rev 1.2", "DMC-41x3")]
    [InlineData("DMC52040", "DMC-520x0")]
    public async Task A_family_that_no_simulated_controller_is_of_is_told(string model, string? family)
    {
        await using var bench = new SimulatedBench(model: model);
        await using var session = await bench.OpenAsync();

        Assert.Equal((model, family), (session.Identity.Model, session.Identity.UntriedFamily));
    }

    [Fact]
    public async Task Something_else_that_answers_is_no_controller()
    {
        var failure = await Assert.ThrowsAsync<ProtocolViolationException>(() => OpenAsync(new ScriptedLink(_ => "SSH-2.0\r\n:")));

        Assert.Contains("SSH-2.0", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nothing_that_changes_the_controller_is_sent_before_everything_was_asked()
    {
        var link = new ScriptedLink(Answer);
        await (await OpenAsync(link)).DisposeAsync();

        var firstChange = link.Received.FindIndex(line => line is "DR 0" or "CW 1" or "CF I" or "VF 10.4");
        var lastQuestion = link.Received.FindLastIndex(line => line.StartsWith("MG _MO", StringComparison.Ordinal));
        Assert.Equal(["", "\x12\x16", "WH", "QZ", "TC1"], link.Received.Take(5));
        Assert.InRange(firstChange, lastQuestion + 1, link.Received.Count);
        Assert.DoesNotContain(link.Received, line => line is "RS" or "BN" or "BP" or "ST" or "HX" || line.StartsWith("EO", StringComparison.Ordinal));
    }

    [Fact]
    public async Task What_the_controller_cannot_say_is_not_fitted_and_not_restored()
    {
        var link = new ScriptedLink(line => line switch { "MG _IA2{F10.0}" or "MG _DR0{F10.0}" or "MG _VRS" => "?", "TC1" => "1 Unrecognized command\r\n:", _ => Answer(line) });
        await using var session = await OpenAsync(link);

        Assert.Null(session.Identity.Limits.FreeHandles);
        Assert.Null(session.Found.Wire.RecordPeriod);
        await session.RestoreAsync(CancellationToken.None);
        Assert.DoesNotContain(link.Received, line => line.StartsWith("VR ", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Whatever_is_refused_at_connect_the_session_opens_or_says_that_it_is_no_controller()
    {
        var link = new ScriptedLink(Answer);
        await (await OpenAsync(link)).DisposeAsync();
        for (var refused = 0; refused < link.Received.Count; refused++)
        {
            var said = -1;
            var isReason = false;
            var stubborn = new ScriptedLink(line =>
            {
                if (isReason && line == "TC1")
                {
                    isReason = false;
                    return "1 Unrecognized command\r\n:";
                }

                isReason = ++said == refused;
                return isReason ? "?" : Answer(line);
            });
            if (link.Received[refused] is "\x12\x16") await Assert.ThrowsAsync<ProtocolViolationException>(() => OpenAsync(stubborn));
            else await (await OpenAsync(stubborn)).DisposeAsync();
        }
    }

    [Fact]
    public async Task A_controller_without_a_data_record_is_taken_as_it_is()
    {
        await using var session = await OpenAsync(new ScriptedLink(line => line switch { "QZ" => "?", "TC1" => "1 Unrecognized command\r\n:", _ => Answer(line) }));

        Assert.Null(session.Identity.RecordBytes);
    }

    [Fact]
    public async Task When_every_handle_is_taken_the_session_does_not_open_and_frees_what_it_had()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, HandleCount = 1 });
        var end = await controller.ListenTcpAsync(0, CancellationToken.None);

        await Assert.ThrowsAnyAsync<ControllerException>(() => ControllerSession.OpenAsync(
            async cancellation => await TcpLink.ConnectAsync("127.0.0.1", end.Port, TimeSpan.FromSeconds(60), TimeProvider.System, cancellation),
            new SessionOptions { ReplyTimeout = TimeSpan.FromSeconds(60) }, TimeProvider.System, CancellationToken.None));

        await controller.WaitUntilAsync(status => status.OpenHandles == 0, CancellationToken.None);
    }

    [Fact]
    public async Task Text_that_a_program_prints_arrives_beside_the_replies()
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync("#A\nMG \"HELLO: 1?\"\nEN");
        var messages = new List<string>();
        await using var session = await ControllerSession.OpenAsync(
            _ => Task.FromResult<IControllerLink>(new StreamLink(bench.Controller.OpenConnection(), "memory")),
            new SessionOptions { MessageReceived = messages.Add }, TimeProvider.System, CancellationToken.None);

        await session.Commands.SendAsync("XQ #A,2", CancellationToken.None);
        bench.Controller.Advance(TimeSpan.FromSeconds(1));
        var reply = await session.StopHandle.SendAsync("MG 1", CancellationToken.None);

        Assert.Equal(["HELLO: 1?"], messages);
        Assert.Equal(new Accepted("1.0000"), reply);
    }

    [Fact]
    public async Task A_data_record_has_the_length_that_QZ_promised()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();

        var record = Assert.IsType<Accepted>(await session.Commands.ReadRecordAsync(session.Identity.RecordBytes!.Value, CancellationToken.None));

        Assert.Equal(156, record.Data.Length);
        Assert.Equal(('\x87', '\x0F'), (record.Data[0], record.Data[1]));
    }

    [Fact]
    public async Task Both_handles_are_free_again_after_the_session()
    {
        await using var bench = new SimulatedBench();

        await (await bench.OpenAsync()).DisposeAsync();

        Assert.Equal(0, bench.Controller.Status.OpenHandles);
    }

    private static Task<ControllerSession> OpenAsync(ScriptedLink link) =>
        ControllerSession.OpenAsync(_ => Task.FromResult<IControllerLink>(link), new SessionOptions { SecondHandle = false }, new ManualTimeProvider(), CancellationToken.None);

    private static string Answer(string line) => line switch
    {
        "\x12\x16" => "DMC2123 Rev 1.0o\r\n:",
        "WH" => "IHC\r\n:",
        "QZ" => " 2, 24, 16, 28\r\n:",
        "TC1" => "0\r\n:",
        _ when line.StartsWith("MG ", StringComparison.Ordinal) => " 1.0000\r\n:",
        _ => ":",
    };
}
