using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Sending;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Tests.Sending;

public class ProgramSenderTests
{
    private const byte Xon = 0x11;
    private const byte Xoff = 0x13;

    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);

    [Fact]
    public async Task Nothing_is_sent_faster_than_the_line_carries_it_with_its_pauses()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time);
        var pace = new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(10)) { LineDelay = TimeSpan.FromMilliseconds(500) };
        var result = await FinishAsync(ProgramSender.SendAsync(line, Job(4, 30), pace, null, time, CancellationToken.None), time);

        Assert.Equal((SendOutcome.Complete, 4, 128), (result.Outcome, result.Lines, result.Characters));
        Assert.True(line.WasDrained);
        Assert.InRange(result.Seconds, (128 * 0.010) + (4 * 0.5) - 1e-6, 30.0);
        for (var i = 0; i < line.Written.Count; i++) Assert.True(line.Written[i].At >= TimeSpan.FromMilliseconds(((i - (i % 32)) * 10) + (i / 32 * 500)), $"character {i}");
    }

    [Fact]
    public async Task With_a_pause_behind_each_character_every_one_goes_out_alone()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time);
        var pace = new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(10)) { CharacterDelay = TimeSpan.FromMilliseconds(40) };
        await FinishAsync(ProgramSender.SendAsync(line, Job(2, 8), pace, null, time, CancellationToken.None), time);

        // A late timer on a busy computer is compensated by at most 5 ms.
        Assert.Equal(20, line.Written.Count);
        for (var i = 1; i < line.Written.Count; i++) Assert.True(line.Written[i].At - line.Written[i - 1].At >= TimeSpan.FromMilliseconds(45), $"character {i}");
    }

    [Fact]
    public async Task XOFF_is_obeyed_within_a_few_characters_until_XON_is_heard()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time) { Answer = (100, CharacterFrame.SevenOdd.Encode(Xoff)) };
        var pace = new SendPace(CharacterFrame.SevenOdd, TimeSpan.FromMilliseconds(1));
        var sending = ProgramSender.SendAsync(line, Job(20, 20), pace, null, time, CancellationToken.None);
        while (line.Answer is not null) await PassAsync(time);
        var sent = line.Count;
        for (var i = 0; i < 200; i++) await PassAsync(time);

        Assert.InRange(sent, 100, 107);
        Assert.Equal(sent, line.Count);
        Assert.False(sending.IsCompleted);

        line.Receive(CharacterFrame.SevenOdd.Encode(Xon));
        var result = await FinishAsync(sending, time);
        Assert.Equal((SendOutcome.Complete, 20, 1, 0L), (result.Outcome, result.Lines, result.Pauses, result.ReceivedBytes));
    }

    [Fact]
    public async Task A_hold_that_does_not_end_is_told_with_the_lines_that_are_out()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time) { Answer = (100, Xoff) };
        var pace = new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(1)) { MaxPause = TimeSpan.FromSeconds(5) };
        var result = await FinishAsync(ProgramSender.SendAsync(line, Job(20, 20), pace, null, time, CancellationToken.None), time);

        Assert.Equal((SendOutcome.PausedTooLong, 4, 20, 1), (result.Outcome, result.Lines, result.TotalLines, result.Pauses));
        Assert.Equal("Sending failed: the receiver sent XOFF and did not send XON within 5 s. 4 of 20 lines were sent.", SendWording.Of(result));
        Assert.False(line.WasDrained);
    }

    [Fact]
    public async Task Without_flow_control_XOFF_is_a_character_like_others()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time) { Answer = (100, Xoff) };
        var result = await FinishAsync(ProgramSender.SendAsync(line, Job(20, 20), new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(1)) { ObeysXoff = false }, null, time, CancellationToken.None), time);

        Assert.Equal((SendOutcome.Complete, 20, 0), (result.Outcome, result.Lines, result.Pauses));
    }

    [Fact]
    public async Task A_stop_says_how_many_lines_are_out_also_while_the_other_side_holds()
    {
        var time = new ManualTimeProvider();
        using var stop = new CancellationTokenSource();
        var line = new MemoryPort(time) { Answer = (100, Xoff) };
        var sending = ProgramSender.SendAsync(line, Job(20, 20), new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(1)), null, time, stop.Token);
        while (line.Answer is not null) await PassAsync(time);
        await stop.CancelAsync();
        var result = await FinishAsync(sending, time);

        Assert.Equal((SendOutcome.Stopped, 4, 20), (result.Outcome, result.Lines, result.TotalLines));
        Assert.Equal("Stopped: 4 of 20 lines were sent.", SendWording.Of(result));
    }

    [Fact]
    public async Task A_line_that_goes_is_told_with_the_lines_that_are_out()
    {
        var time = new ManualTimeProvider();
        var line = new MemoryPort(time) { BreaksAt = 50 };
        var result = await FinishAsync(ProgramSender.SendAsync(line, Job(20, 20), new SendPace(CharacterFrame.EightNone, TimeSpan.FromMilliseconds(1)), null, time, CancellationToken.None), time);

        Assert.Equal((SendOutcome.LinkLost, 2, "the cable was pulled"), (result.Outcome, result.Lines, result.Reason));
    }

    /// <summary>The receiver of a real terminal reads irregularly, and pauses and resumes the sender at random.</summary>
    [Theory]
    [InlineData(CharacterFrame.SevenEven, 1, SerialDriver.Own)]
    [InlineData(CharacterFrame.EightNone, 2, SerialDriver.Own)]
    [InlineData(CharacterFrame.SevenEven, 3, SerialDriver.Ports)]
    public async Task Over_a_pseudo_terminal_every_character_comes_in_order_with_its_parity_however_often_it_is_held(CharacterFrame frame, int seed, SerialDriver driver)
    {
        using var cable = new PseudoTerminalPair();
        var address = new SendAddress(cable.Device, 115200, frame, SerialFlow.XonXoff) { Driver = driver };
        var lines = SendText.Lines(Encoding.ASCII.GetBytes(string.Concat(Enumerable.Range(1, 150).Select(i => $"\t{i:000}\t01\t000\t+{i * 37:000000}\n"))));
        var job = SendText.Encode(lines, new SendFormat { LeaderNuls = 20, TrailerNuls = 20, Start = "%\r\n" }, frame).Job!;
        var receiver = new ProgramReceiver(frame);
        await using var line = SerialProgramPort.Open(address, s_patience, TimeProvider.System);
        var hearing = Task.Run(() => Hear(cable, receiver, job.Length, frame, new Random(seed)));
        var result = await ProgramSender.SendAsync(line, job, new SendPace(frame, address.CharacterTime), null, TimeProvider.System, CancellationToken.None).WaitAsync(s_patience);
        await hearing.WaitAsync(s_patience);

        Assert.Equal((SendOutcome.Complete, 150, job.Length), (result.Outcome, result.Lines, result.Characters));
        Assert.True(result.Pauses > 2);
        Assert.Equal((0, "%\r\n" + string.Concat(lines.Select(one => Encoding.ASCII.GetString(one.Span) + "\r\n"))), (receiver.Damaged, Encoding.ASCII.GetString([.. receiver.Characters])));
    }

    [Theory]
    [InlineData(SerialDriver.Own)]
    [InlineData(SerialDriver.Ports)]
    public async Task A_pulled_adapter_ends_the_sending_with_the_lines_that_are_out(SerialDriver driver)
    {
        var cable = new PseudoTerminalPair();
        var address = new SendAddress(cable.Device, 115200, CharacterFrame.EightNone, SerialFlow.XonXoff) { Driver = driver };
        await using var line = SerialProgramPort.Open(address, s_patience, TimeProvider.System);
        var pulling = Task.Run(() =>
        {
            cable.Read(400);
            cable.Dispose();
        });
        var result = await ProgramSender.SendAsync(line, Job(2000, 30), new SendPace(CharacterFrame.EightNone, address.CharacterTime), null, TimeProvider.System, CancellationToken.None).WaitAsync(s_patience);
        await pulling.WaitAsync(s_patience);

        Assert.Equal(SendOutcome.LinkLost, result.Outcome);
        Assert.InRange(result.Lines, 11, 1999);
        Assert.NotNull(result.Reason);
    }

    [Fact]
    public void A_receiver_counts_wrong_parities_and_names_the_line_of_the_first()
    {
        var receiver = new ProgramReceiver(CharacterFrame.SevenEven);
        byte[] bits = [.. "\0G1\r\nG2\r\nG3\r\n"u8.ToArray().Select(character => CharacterFrame.SevenEven.Encode(character))];
        bits[5 + 1] ^= 0x80;
        bits[9] ^= 0x80;
        receiver.Add(bits.AsSpan(0, 7));
        receiver.Add(bits.AsSpan(7));

        Assert.Equal((2, 2, 3, "G1\r\nG2\r\nG3\r\n"), (receiver.Damaged, receiver.FirstDamagedLine, receiver.Lines, Encoding.ASCII.GetString([.. receiver.Characters])));
    }

    private static SendJob Job(int lines, int characters) => SendText.Encode([.. Enumerable.Range(0, lines).Select(i => (ReadOnlyMemory<byte>)Encoding.ASCII.GetBytes(new string((char)('A' + (i % 26)), characters)))], SendFormat.Default, CharacterFrame.EightNone).Job!;

    private static void Hear(PseudoTerminalPair cable, ProgramReceiver receiver, long all, CharacterFrame frame, Random random)
    {
        for (var heard = 0L; heard < all;)
        {
            var some = cable.ReadSome(1 + random.Next(60));
            heard += some.Length;
            receiver.Add(Encoding.Latin1.GetBytes(some));
            if (random.Next(4) != 0) continue;
            cable.Write(((char)frame.Encode(Xoff)).ToString());
            cable.Write(((char)frame.Encode(Xon)).ToString());
        }
    }

    private static async Task PassAsync(ManualTimeProvider time)
    {
        time.Advance(TimeSpan.FromMilliseconds(1));
        await Task.Yield();
    }

    private static async Task<SendResult> FinishAsync(Task<SendResult> sending, ManualTimeProvider time)
    {
        while (!sending.IsCompleted) await PassAsync(time);
        return await sending;
    }
}
