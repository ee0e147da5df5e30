namespace Engraver.Simulator.Tests;

/// <summary>Inputs that once ended the controller or blocked a connection, each in its shortest form; <see cref="Fuzzing.FuzzTests"/> searches for
/// more.</summary>
public class SurvivalTests
{
    [Theory]
    [InlineData("LMA;LI 1600;LE;BGS", "_RPA", 1600)]
    [InlineData("LMA;LI -1600;LE;BGS", "_RPA", -1600)]
    [InlineData("CAT;LMC;LI ,,250;LE;BGT", "_RPC", 250)]
    [InlineData("LMD;LID=77;LE;BGS", "_RPD", 77)]
    public async Task A_sequence_may_have_a_single_axis(string sequence, string operand, double end)
    {
        await using var rig = new SimulatorRig();

        rig.Do(sequence.Split(';')).RunToIdle();

        Assert.Equal(end, rig.Value(operand));
    }

    [Fact]
    public async Task The_tangent_of_a_single_axis_is_forwards_or_backwards()
    {
        await using var rig = new SimulatorRig();
        rig.Do("LMA", "TN 2,0", "LI -100");

        Assert.Equal(" 360\r\n:", rig.Ask("TN ?"));
    }

    [Theory]
    [InlineData("PF -2147483648")]
    [InlineData("PF 2147483648")]
    [InlineData("VF -2147483648")]
    [InlineData("VF 2147483648")]
    [InlineData("VF $80000000")]
    [InlineData("DM p[4];RA p[];RD _TPA;RC 1,-2147483648")]
    public async Task A_number_at_the_end_of_the_range_is_refused_and_the_next_command_answered(string sent)
    {
        await using var rig = new SimulatorRig();
        Assert.EndsWith("?", rig.Ask(sent));

        Assert.Equal(" 1.0000\r\n:", rig.Ask("MG 1"));
    }

    [Fact]
    public async Task An_input_number_at_the_end_of_the_range_is_an_error_of_the_program()
    {
        await using var rig = new SimulatorRig();

        rig.Run("AI -2147483648\nEN");

        Assert.Equal(0, rig.Value("_NO"));
    }

    [Fact]
    public async Task A_position_error_beyond_the_range_is_told_as_the_largest()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DPA=-2147483648");
        rig.Controller.HoldMotor(0, true);
        rig.Do("JGA=0", "BGA", "IPA=2147483647", "IPA=1").Pass(5);

        Assert.Equal(" 2147483647\r\n:", rig.Ask("TEA"));
        Assert.Equal(0xC0, (int)rig.Value("_TSA") & 0xC0);
    }

    [Fact]
    public async Task Gears_that_drive_each_other_run_to_the_end_of_the_numbers_and_no_further()
    {
        await using var rig = new SimulatorRig();
        rig.Do("GAA=B", "GAB=A", "GR 127,127", "IPA=1").Pass(2000);
        Assert.Equal(2147483647, Math.Abs(rig.Value("_RPA")), 1.0);

        rig.Do("AB1", "GR 0,0", "PAA=4", "SPA=12000000", "BGA", "STA").RunUntilStill();
        Assert.InRange(Math.Abs(rig.Value("_RPA")), 2147000000, 2147483648);
    }

    [Theory]
    [InlineData("DL\r", "?::")]
    [InlineData("DM p[10]\rQD p[]\r", "?")]
    public async Task A_text_without_end_fills_no_memory_and_is_refused(string begin, string end)
    {
        await using var rig = new SimulatorRig();
        rig.SendRaw(begin);
        var much = new byte[1_000_000];
        Array.Fill(much, (byte)'1');
        var before = GC.GetAllocatedBytesForCurrentThread();

        for (var i = 0; i < 20; i++) rig.Stream.Write(much);

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 2_000_000);
        Assert.Equal(end, rig.SendRaw("\\"));
        Assert.Equal(" 1.0000\r\n:", rig.Ask("MG 1"));
    }

    [Theory]
    [InlineData("JGE=1")]
    [InlineData("SPH=?")]
    [InlineData("LIE=5")]
    public async Task An_axis_that_the_machine_has_not_is_refused_as_one(string sent)
    {
        await using var rig = new SimulatorRig();
        rig.Do("LMAB");

        Assert.Equal(90, rig.Refusal(sent));
    }

    [Fact]
    public async Task A_client_that_never_sends_a_return_is_answered_for_ever()
    {
        await using var rig = new SimulatorRig();
        for (var i = 0; i < 100; i++) Assert.Equal(":", rig.SendRaw("ACA=73422;"));

        Assert.Equal(" 72704\r\n:", rig.SendRaw("ACA=?;"));
    }

    [Fact]
    public async Task A_command_that_is_too_long_is_refused_where_it_ends_and_the_next_one_runs()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("?", rig.SendRaw(new string('x', 81) + ";"));
        Assert.Equal(" 5\r\n:", rig.SendRaw("TC;"));
        Assert.Equal("?", rig.SendRaw("MG \"" + new string('x', 80) + ";")); // a quote that is never closed does not protect longer text
        Assert.Equal(" 1.0000\r\n:", rig.SendRaw("MG 1;"));
    }
}
