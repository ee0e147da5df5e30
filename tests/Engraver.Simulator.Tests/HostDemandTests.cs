using System.Text;

namespace Engraver.Simulator.Tests;

/// <summary>galil-dmc.md L.2: needs of real host programs. Points 1, 3, 4 and 10 are also in ProtocolTests, 6 in LinkTests and UdpTests.</summary>
public class HostDemandTests
{
    [Theory] // point 1
    [InlineData("\r\r\r", ":::")]
    [InlineData("x=1;;y=2\r", ":::")]
    [InlineData("\nx=1\n\r\n", ":")]
    [InlineData("MG\"a;b:c\";MG\"d\"\r", "a;b:c\r\n:d\r\n:")]
    public async Task Point_1_n_parts_give_n_prompts(string sent, string reply)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(reply, rig.SendRaw(sent));
    }

    [Fact] // point 2
    public async Task Point_2_a_refused_part_answers_alone_and_the_rest_is_executed()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(":??:", rig.Ask("x=1;QQ;SPA=-;y=2"));
        Assert.Equal((1, 2), (rig.Value("x"), rig.Value("y")));
    }

    [Theory] // point 3
    [InlineData("DL\r#A\rEN\r\\")]
    [InlineData("DL\r#A\rEN\\")]
    [InlineData("DL\r\n#A\r\nEN\r\n\x1A\r\n")]
    public async Task Point_3_a_download_in_one_piece_or_byte_by_byte(string text)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("::", rig.SendRaw(text));
        Assert.Equal("::", string.Concat(text.Select(c => rig.SendRaw(c.ToString()))));
        Assert.Equal("#A\r\nEN\r\n\x1A:", rig.Ask("UL"));
    }

    [Fact] // point 4
    public async Task Point_4_uploads_end_with_control_Z_and_a_prompt()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("\r\n\x1A:", rig.Ask("UL"));
        Assert.Equal(" 0.0000\r\n\x1A:", rig.Do("DM p[1]").Ask("QU p[]"));
        Assert.Equal("?", rig.Do("DM eightchr[1]").Ask("QU eightchr[]"));
    }

    [Fact] // point 5
    public async Task Point_5_with_the_factory_CF_nobody_on_Ethernet_hears_a_message()
    {
        await using var rig = new SimulatorRig();
        rig.Download("MG \"HI\"\nEN").Do("CW 1", "XQ").Pass(20);
        Assert.Equal("", SimulatorRig.ReadAvailable(rig.Stream));

        var heard = rig.Do("CF A").Ask("XQ") + SimulatorRig.ReadAvailable(rig.Pass(20).Stream);

        Assert.Equal(":\u00C8\u00C9\u008D\u008A", heard);
    }

    [Fact] // point 6
    public async Task Point_6_handles_close_with_and_without_the_arrow()
    {
        await using var rig = new SimulatorRig();
        using var first = rig.Controller.OpenConnection();
        using var second = rig.Controller.OpenConnection();

        Assert.Equal(":", SimulatorRig.Exchange(first, "IHS=-3\r"));
        Assert.Equal((6, 0), (rig.Value("_IA2"), rig.Value("_IHB2")));
        Assert.Equal(":", rig.Ask("IHT=-3"));
        Assert.Equal((7, 2), (rig.Value("_IA2"), rig.Value("_IHA2")));
    }

    [Fact] // point 7
    public async Task Point_7_the_record_tells_direction_and_speed_of_every_kind_of_motion()
    {
        await using var rig = new SimulatorRig();
        rig.Do("GAB=A", "GRB=-2", "JGA=5000", "JGC=-3000", "BGAC").Pass(200);

        var record = Encoding.Latin1.GetBytes(rig.Ask("QR"));

        Assert.Equal((0x87, 0x0F, 156), (record[0], record[1], BitConverter.ToUInt16(record, 2)));
        Assert.Equal([5000 * 64, -10000 * 64, -3000 * 64], new[] { 0, 1, 2 }.Select(axis => BitConverter.ToInt32(record, 44 + (28 * axis) + 20)));
        Assert.Equal([0, 0x80, 0x80], new[] { 0, 1, 2 }.Select(axis => BitConverter.ToUInt16(record, 44 + (28 * axis)) & 0x80));
    }

    [Fact] // point 7
    public async Task Point_7_the_record_tells_the_phases_of_a_motion()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nWT 5000\nEN").Do("PRC=10000", "BGC", "VMAB", "VP 9000,0", "VE", "BGS");

        var phases = new List<(int General, int Plane, int Axis)>();
        for (var i = 0; i < 60; i++) phases.Add(Phases(Encoding.Latin1.GetBytes(rig.Pass(10).Ask("QR"))));
        Assert.Equal([0, 1 << 5, 1 << 3, 0], phases.Select(p => p.Plane & 0x38).Aggregate(new List<int> { 0 }, AddChange));
        Assert.Equal([0, 1 << 5, 1 << 3, 0], phases.Select(p => p.Axis & 0x38).Aggregate(new List<int> { 0 }, AddChange));

        Assert.Equal(0x83, Phases(Encoding.Latin1.GetBytes(rig.Do("TR 1", "XQ").Ask("QR"))).General);
    }

    private static (int General, int Plane, int Axis) Phases(byte[] record) =>
        (record[27], BitConverter.ToUInt16(record, 30), BitConverter.ToUInt16(record, 44 + (2 * 28)));

    private static List<int> AddChange(List<int> seen, int next)
    {
        if (seen[^1] != next) seen.Add(next);
        return seen;
    }

    [Fact] // point 8
    public async Task Point_8_blank_and_surplus_fields_and_decimals_are_taken()
    {
        await using var rig = new SimulatorRig();

        rig.Do("CA S;CS S;LM AB;VAS=8192;VDS=8192;VSS=8000", "LI 1600,-800,,,;LE", "BG S").RunToIdle();
        Assert.Equal((1600, -800), (rig.Value("_RPA"), rig.Value("_RPB")));

        rig.Do("DPA=0.000;DP ,0.0", "SH A,B,C", "PR 10,20,,,", "BG A,B").RunToIdle();
        Assert.Equal((10, 20), (rig.Value("_RPA"), rig.Value("_RPB")));
        rig.Do("MO A", "MT 2.0", "KPA=0.000000", "FLA=100000.500000");
        Assert.Equal((2, 0, 100000), (rig.Value("_MTA"), rig.Value("_KPA"), rig.Value("_FLA")));
        Assert.Equal(" 8192\r\n:", rig.Ask("VAS="));
    }

    [Fact] // point 9
    public async Task Point_9_names_that_begin_like_commands_are_names()
    {
        await using var rig = new SimulatorRig();
        rig.Do("speedA=3", "stop1=4", "slimflA=5", "g_hmstA=6", "ENDx=7", "STATE=8");
        rig.Run("#Hm_rdz;n=0\nIF (1=1);n=n+1;ENDIF;n=n+10\nJP#Hm_go\nEN\n#Hm_go;n=n+100;EN");

        Assert.Equal((111, 33), (rig.Value("n"), rig.Value("speedA+stop1+slimflA+g_hmstA+ENDx+STATE")));
    }

    [Fact] // point 10
    public async Task Point_10_accelerations_are_floored_and_arithmetic_runs_to_the_right()
    {
        await using var rig = new SimulatorRig();
        rig.Do("ACA=73422;DCA=73422;VA 20000;VD 20000");

        Assert.Equal((72704, 72704, 19456, 19456), (rig.Value("_ACA"), rig.Value("_DCA"), rig.Value("_VAS"), rig.Value("_VDS")));
        Assert.Equal("-9.0000\r\n:", rig.Ask("MG 0-1-2*3"));
    }

    [Fact] // point 11
    public async Task Point_11_a_long_program_of_the_field_is_read_as_it_is()
    {
        await using var rig = new SimulatorRig();
        var lines = Enumerable.Range(0, 52).SelectMany(i => (string[])
        [
            $"#Label{i}", "'a note; x=99", "NO a note", $"  \tn = n + 1 ;' behind", ";;n=n;", "IF (((((n>0)&(n>0))&((n>0)))));m=m+1;ENDIF", i < 51 ? $"JP#Label{i + 1}" : "EN",
            .. Enumerable.Repeat("'", 11),
        ]).ToArray();
        Assert.Equal(936, lines.Length);

        rig.Do("n=0;m=0;x=1").Run(string.Join('\n', lines));

        Assert.Equal((52, 52, 202), (rig.Value("n"), rig.Value("m"), rig.Value("_DL")));
    }

    [Theory] // point 12
    [InlineData("_BGA,_LFA,_LRA,_SCA,_MOA,_DCA,_SPA")]
    [InlineData("TIME,_TPA,_HMA,_ACA,_TC,_NO,_FLA,_BLA")]
    [InlineData("_ED,_XQ0,_TDA,_TM,_VDS")]
    [InlineData("@ABS[-1],@IN[1],@INT[1.5]{F2.1}{N}")]
    public async Task Point_12_operands_and_functions_of_public_programs(string list)
    {
        await using var rig = new SimulatorRig();

        Assert.EndsWith(":", rig.Ask("MG " + list));
    }

    [Fact] // point 12
    public async Task Point_12_what_belongs_to_other_families_and_options_is_refused()
    {
        await using var rig = new SimulatorRig();

        Assert.All(new[] { "LD 3", "HV 100", "MG _LDA", "MG ^c", "PVA=1,2,3", "MG @AN[1]", "AQ 1,2" }, c => Assert.Equal("?", rig.Ask(c)));
        Assert.Equal(":", rig.Ask("~a=2"));
    }

    [Fact] // point 13
    public async Task Point_13_start_values_latency_and_address_are_settings()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions
        {
            MessagePort = 'A', MessageMarking = 1, CommandCost = TimeSpan.FromMilliseconds(10), Address = new System.Net.IPAddress([10, 0, 0, 7]),
            Switches = [new AxisSwitches(0) { ForwardLimitAt = 0 }],
        });

        Assert.Equal((65, 1), (rig.Value("_CF"), rig.Value("_CW")));
        Assert.Equal(20, rig.Controller.Status.Sample);
        Assert.Contains("CONTROLLER IP ADDRESS 10,0,0,7 ", rig.Ask("TH"));
        Assert.Equal(22, rig.Do("JGA=100").Refusal("BGA"));
    }
}
