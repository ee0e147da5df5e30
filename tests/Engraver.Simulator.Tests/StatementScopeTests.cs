namespace Engraver.Simulator.Tests;

/// <summary>Where and when a statement may be given (galil-dmc.md E, the three lists at its end).</summary>
public class StatementScopeTests
{
    [Theory]
    [InlineData("DL", 3)]
    [InlineData("UL", 3)]
    [InlineData("LS", 3)]
    [InlineData("QD x[]", 3)]
    [InlineData("RS", 3)]
    [InlineData("WH", 3)]
    [InlineData("CF I", 3)]
    [InlineData("BN", 17)]
    [InlineData("ED", 1)]
    public async Task Not_in_a_program(string statement, int code)
    {
        await using var rig = new SimulatorRig();
        rig.Do("n=0").Run(statement + "\nn=1\nEN");

        Assert.Equal((code, 0), (rig.Value("_TC"), rig.Value("n")));
    }

    [Theory]
    [InlineData("CEA=1")]
    [InlineData("DPA=5")]
    [InlineData("FEA")]
    [InlineData("FIA")]
    [InlineData("HMA")]
    [InlineData("MOA")]
    [InlineData("MTA=2")]
    [InlineData("PAA=5")]
    [InlineData("PRA=5")]
    [InlineData("SHA")]
    [InlineData("TM 500")]
    [InlineData("DCA=102400")]
    [InlineData("BP")]
    public async Task Not_while_its_axis_moves(string command)
    {
        await using var rig = new SimulatorRig();
        rig.Do("PRA=50000", "BGA").Pass(100);

        Assert.Equal(7, rig.Refusal(command));
        Assert.Equal(21, rig.Refusal("BGA"));
    }

    [Theory]
    [InlineData("VMAB")]
    [InlineData("VD 102400")]
    [InlineData("CSS")]
    [InlineData("ES 1,2")]
    [InlineData("LMAB")]
    public async Task Not_while_its_plane_moves(string command)
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VP 50000,0", "VE", "BGS").Pass(100);

        Assert.Equal(7, rig.Refusal(command));
    }

    [Theory]
    [InlineData("AM")]
    [InlineData("AR 100")]
    [InlineData("AP 100")]
    [InlineData("AI 1")]
    [InlineData("ASA")]
    [InlineData("MRA=5")]
    [InlineData("RI")]
    [InlineData("WC")]
    public async Task Only_in_a_program(string statement)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(2, rig.Refusal(statement));
    }

    [Theory]
    [InlineData("XQ#A,3")]
    [InlineData("HX3")]
    [InlineData("MG 1{N}")]
    [InlineData("NO nothing")]
    [InlineData("DM y[3]")]
    [InlineData("II 2")]
    public async Task In_a_program_and_from_a_host(string statement)
    {
        await using var rig = new SimulatorRig();
        rig.Download("n=0\n" + statement + "\nn=1\nEN\n#A\nEN");
        Assert.EndsWith(":", rig.Ask(statement));

        rig.Do("DA *[]", "XQ").RunToIdle();

        Assert.Equal((0, 1), (rig.Value("_TC"), rig.Value("n")));
    }
}
