namespace Engraver.Simulator.Tests;

/// <summary>How numbers are printed (galil-dmc.md E Messages, A.3 Number reply and Format commands): a value set with up to four decimals is printed unchanged,
/// although a fraction is stored in steps of 1/65536.</summary>
public class NumberReplyTests
{
    [Theory]
    [InlineData("MG 1234.5678", " 1234.5678\r\n:")]
    [InlineData("MG -1234.5678", "-1234.5678\r\n:")]
    [InlineData("MG 42.42", " 42.4200\r\n:")]
    [InlineData("MG 0.6", " 0.6000\r\n:")]
    [InlineData("MG 0.99999", " 1.0000\r\n:")]
    [InlineData("MG 2000/360", " 5.5555\r\n:")] // a division truncates (E, fixed-point traps)
    [InlineData("MG @INT[5*0.6]", " 2.0000\r\n:")] // and 0.6 is stored as 0.59999
    [InlineData("MG _VF,_PF", " 10.4000 10.0000\r\n:")]
    [InlineData("x=42.42;x=?", ": 42.4200\r\n:")]
    [InlineData("MG 1234.5322{F4.2}", " 1234.53\r\n:")]
    [InlineData("MG 99999.99999{F5.4}", " 99999.9999\r\n:")] // a number that does not fit is clipped
    [InlineData("DM px[1];px[0]=0.1;QU px[]", ":: 0.1000\r\n\x1A:")]
    public async Task Numbers_come_back_as_given(string sent, string reply)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(reply, rig.Ask(sent));
    }

    [Fact]
    public async Task Every_number_of_four_decimals_prints_as_it_was_written()
    {
        await using var rig = new SimulatorRig();
        for (var i = 0; i < 10_000; i += 7)
        {
            var number = string.Create(System.Globalization.CultureInfo.InvariantCulture, $"{i * 3}.{i:0000}");

            Assert.Equal($" {number}\r\n:", rig.Ask("MG " + number));
        }
    }

    [Theory]
    [InlineData("TPA", " 0000000200\r\n:")]
    [InlineData("TP", " 0000000200, -0000000010, 0000000000, 0000000000\r\n:")]
    [InlineData("SP ?", " 0000025000\r\n:")]
    [InlineData("VS ?", " 0000025000\r\n:")]
    [InlineData("VSS=?", " 0000025000\r\n:")]
    [InlineData("KPA=?", " 0000000006.00\r\n:")]
    [InlineData("PA ?,?", " 0000000200, -0000000010\r\n:")]
    [InlineData("LM ?", " 0000000511\r\n:")]
    [InlineData("x=5;x=?", ": 0000000005.0000\r\n:")]
    [InlineData("PF 4;TPA", ": 0200\r\n:")]
    [InlineData("LZ 1;TPA", ": 200\r\n:")]
    public async Task Without_the_stripping_of_zeros_every_question_answers_padded(string sent, string reply)
    {
        await using var rig = new SimulatorRig();
        rig.Do("DP 200,-10", "LZ 0");

        Assert.Equal(reply, rig.Ask(sent));
    }

    [Theory]
    [InlineData("PF ?", " 10.0\r\n:")]
    [InlineData("VF ?", " 10.4\r\n:")]
    [InlineData("PF 8.2;PF ?", ": 8.2\r\n:")]
    [InlineData("VF -6.2;VF ?", ":-6.2\r\n:")]
    [InlineData("GAA=?", " 0\r\n:")]
    [InlineData("GAA=S;GAA=?", ": S\r\n:")]
    [InlineData("GA ,S,T;GA ?,?,?", ": 0, S, T\r\n:")]
    [InlineData("GAA=N;GAA=", ": N\r\n:")]
    public async Task Formats_and_masters_can_be_asked_for(string sent, string reply)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(reply, rig.Ask(sent));
    }
}
