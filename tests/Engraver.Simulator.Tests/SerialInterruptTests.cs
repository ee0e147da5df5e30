namespace Engraver.Simulator.Tests;

/// <summary>CI, #COMINT and the input of the program from the serial port (galil-dmc.md C.3).</summary>
public class SerialInterruptTests
{
    private const string Reader = """
        n=0;CI 1,1
        #IDLE
        WT 1000
        JP#IDLE
        #COMINT
        n=n+1;code=P1CD;last=P1CH
        IF (code=3)
        value=P1NM
        ENDIF
        IF (code=2)
        text=P1ST
        ENDIF
        then=P1CD
        EN 1,1
        """;

    [Fact]
    public async Task A_number_and_a_text_reach_the_program_and_are_no_commands()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\r");
        rig.Download(Reader).Do("XQ").Pass(20);

        Assert.Equal("", SimulatorRig.Exchange(serial, "-12.5\r"));
        rig.Pass(20);
        Assert.Equal((1, 3, -12.5), (rig.Value("n"), rig.Value("code"), rig.Value("value")));
        Assert.Equal(0, rig.Value("then"));

        Assert.Equal("", SimulatorRig.Exchange(serial, "SB1;RUNNING\r"));
        rig.Pass(20);
        Assert.Equal("SB1;RU\r\n:", rig.Ask("MG text{S6}"));
        Assert.Equal((2, 2, 0), (rig.Value("n"), rig.Value("code"), rig.Value("@OUT[1]")));
    }

    [Fact]
    public async Task Without_the_second_field_the_line_is_a_command_as_well()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\r");
        rig.Download(Reader.Replace("CI 1,1", "CI 1")).Do("XQ").Pass(20);

        Assert.Equal(":", SimulatorRig.Exchange(serial, "SB1\r"));
        rig.Pass(20);

        Assert.Equal((1, 2, 1), (rig.Value("n"), rig.Value("code"), rig.Value("@OUT[1]")));
    }

    [Fact]
    public async Task CI_2_interrupts_at_every_character()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        SimulatorRig.Exchange(serial, "EO 0\r");
        rig.Download(Reader.Replace("CI 1,1", "CI 2,1")).Do("XQ").Pass(20);

        foreach (var key in "GO")
        {
            SimulatorRig.Exchange(serial, key.ToString());
            rig.Pass(20);
        }

        Assert.Equal((2, 1), (rig.Value("n"), rig.Value("code")));
        Assert.Equal("O\r\n:", rig.Ask("MG last{S1}"));
    }

    [Theory]
    [InlineData("EN 1,1", 2)]
    [InlineData("EN 1", 1)]
    public async Task Only_the_second_argument_of_EN_arms_the_interrupt_again(string end, int interrupts)
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        rig.Download(Reader.Replace("EN 1,1", end)).Do("XQ").Pass(20);

        SimulatorRig.Exchange(serial, "1\r");
        rig.Pass(20);
        SimulatorRig.Exchange(serial, "2\r");
        rig.Pass(20);

        Assert.Equal(interrupts, rig.Value("n"));
    }

    [Fact]
    public async Task What_arrives_while_the_handler_runs_replaces_what_was_there()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        rig.Download(Reader.Replace("n=n+1;code", "n=n+1\nWT 50\ncode")).Do("XQ").Pass(20);

        SimulatorRig.Exchange(serial, "1\r2\r3\r");
        rig.Pass(200);

        Assert.Equal((1, 3), (rig.Value("n"), rig.Value("value")));
    }

    [Fact]
    public async Task COMINT_needs_a_running_thread_0_whatever_the_other_handlers_need()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { HandlersNeedThreadZero = false });
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        rig.Download(Reader).Do("n=0", "CI 1,1");

        SimulatorRig.Exchange(serial, "7\r");
        rig.Pass(20);

        Assert.Equal((0, 3, 7), (rig.Value("n"), rig.Value("P1CD"), rig.Value("P1NM")));
        Assert.Equal(0, rig.Value("P1CD"));
    }

    [Fact]
    public async Task CI_tells_its_state_clears_and_ends()
    {
        await using var rig = new SimulatorRig();
        await using var serial = rig.Controller.OpenSerialConnection(19200);
        Assert.Equal(-1, rig.Value("P1CD"));

        rig.Do("CI 1,1");
        SimulatorRig.Exchange(serial, "AB");
        Assert.Equal(1, rig.Value("P1CD"));
        Assert.Equal(0, rig.Do("CI -1").Value("P1CD"));
        Assert.Equal(6, rig.Refusal("CI 3"));
        Assert.Equal(9, rig.Refusal("P1CD=1"));
        Assert.Equal(-1, rig.Do("CI 0").Value("P1CD"));
        Assert.EndsWith(":", SimulatorRig.Exchange(serial, "EO 0\r"));
    }
}
