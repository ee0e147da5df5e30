using System.Text;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Simulator.Tests;

/// <summary>galil-dmc.md A.3, A.6 and L.2.</summary>
public class ProtocolTests
{
    [Theory]
    [InlineData("\r", ":")]
    [InlineData("x=2;y=5\r", "::")]
    [InlineData("x=2\r\nMG x\r\n", ": 2.0000\r\n:")]
    [InlineData("MG1+2;MG3+4\r", " 3.0000\r\n: 7.0000\r\n:")]
    [InlineData("MG\"x=4:y=5;z\"\r", "x=4:y=5;z\r\n:")]
    [InlineData("QQ;MG 1\r", "? 1.0000\r\n:")]
    [InlineData("ACA=73422;", ":")]
    [InlineData("bg\r", "?")]
    [InlineData("hswactA=0\n\r", ":")]
    [InlineData("\x12\x16\r", "DMC2143 Rev 1.0o\r\n:")]
    [InlineData("WH\r", "IHA\r\n:")]
    [InlineData("QZ\r", " 4, 24, 16, 28\r\n:")]
    [InlineData("TP\r", " 0, 0, 0, 0\r\n:")]
    [InlineData("DR 0\r", ":")]
    [InlineData("EO 0\r", "?")]
    [InlineData("MG _EO\r", " 0.0000\r\n:")]
    [InlineData("MG @AN[1]\r", "?")]
    [InlineData("MG_CO\r", "?")]
    [InlineData("ID\r", "?")]
    [InlineData("LD ?\r", "?")]
    [InlineData("MG @OUT[-1]\r", "?")]
    [InlineData("IHT=>-3\r", ":")]
    [InlineData("IHT=-3;\r", "::")]
    [InlineData("UL\r", "\r\n\x1A:")]
    public async Task Every_command_gets_one_prompt_behind_its_data(string sent, string reply)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(reply, rig.SendRaw(sent));
    }

    [Theory]
    [InlineData("VA 20000", "VA ?", " 19456\r\n:")]
    [InlineData("ACA=73422", "ACA=?", " 72704\r\n:")]
    [InlineData("SP 5001,7000", "SP ?,?", " 5000, 7000\r\n:")]
    [InlineData("VSS=4000", "VSS=?", " 4000\r\n:")]
    [InlineData("VS 4000,600", "VS ?,?", " 4000, 600\r\n:")]
    [InlineData("VR 0.5", "VR ?", " 0.5000\r\n:")]
    [InlineData("x=5", "x=?", " 5.0000\r\n:")]
    [InlineData("x=-5", "x=", "-5.0000\r\n:")]
    [InlineData("DP 10000;PA 8000", "PR ?", "-2000\r\n:")]
    [InlineData("MO A;MT 2.0;MTA=-2", "MTA=?", "-2.0\r\n:")]
    [InlineData("DM px[10]", "DM ?", " 7990\r\n:")]
    [InlineData("speedA=3;stop1=4", "MG speedA,stop1", " 3.0000 4.0000\r\n:")]
    [InlineData("MG x=3", "TC", " 9\r\n:")]
    [InlineData("TC", "TC1", " 0\r\n:")]
    [InlineData("QQ", "TC1", "1 Unrecognized command\r\n:")]
    [InlineData("AMS", "TC", " 2\r\n:")]
    [InlineData("CAT", "CA ?", " 1\r\n:")]
    public async Task What_was_set_is_read_back(string set, string query, string reply)
    {
        await using var rig = new SimulatorRig();
        rig.Ask(set);

        Assert.Equal(reply, rig.Ask(query));
    }

    [Theory]
    [InlineData("x=4.1", "{F5.2}", " 00004.10")]
    [InlineData("x=7", "{Z4.2}", " 7.00")]
    [InlineData("x=999999.999", "{F5.2}", " 99999.99")]
    [InlineData("x=255", "{$4.0}", " $00FF")]
    [InlineData("x=\"ABC\"", "{S3}", "ABC")]
    public async Task Formats_pad_clip_and_cut(string set, string format, string printed)
    {
        await using var rig = new SimulatorRig();
        rig.Do(set);

        Assert.Equal(printed + "\r\n:", rig.Ask("MG x" + format));
        Assert.Equal(printed + ":", rig.Ask("MG x" + format + "{N}"));
    }

    [Fact]
    public async Task Program_only_statements_are_refused_from_a_host_with_code_2()
    {
        await using var rig = new SimulatorRig();

        Assert.All(
            new[] { "WT 100", "AT 0", "AMS", "MCA", "AV 100", "AD 5", "JP#A", "JS#A", "EN", "IF (1)", "ELSE", "ENDIF", "RE", "ZS", "MFA=5" },
            c => Assert.Equal(2, rig.Refusal(c)));
    }

    [Fact]
    public async Task A_line_over_80_characters_is_refused_with_code_5_and_counts_once()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(5, rig.Refusal("MG \"" + new string('x', 90) + "\""));
        Assert.Equal(":", rig.Ask("MG \"" + new string('x', 75) + "\"")[^1..]);
    }

    [Theory]
    [InlineData("\\")]
    [InlineData("\x1A")]
    [InlineData("\x11")]
    [InlineData("\x04")]
    public async Task Download_is_silent_until_its_terminator_then_answers_two_prompts(string terminator)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("", rig.SendRaw("DL\r#A\rx=1;'note\r\rEN\r"));
        Assert.Equal("::", rig.SendRaw(terminator + "\r"));
        Assert.Equal("#A\r\nx=1;'note\r\nEN\r\n\x1A:", rig.Ask("UL"));
        Assert.Equal(" 1.0000\r\n:", rig.Do("XQ#A").Pass(10).Ask("MG x"));
    }

    [Fact]
    public async Task A_bad_line_of_a_download_is_answered_while_it_streams_and_nothing_is_kept()
    {
        await using var rig = new SimulatorRig();

        Assert.Equal("?", rig.SendRaw("DL\r#A\r" + new string('x', 81) + "\r"));
        Assert.Equal("::", rig.SendRaw("EN\r\\"));
        Assert.Equal(" 60\r\n:", rig.Ask("TC"));
        Assert.Equal("\r\n\x1A:", rig.Ask("UL"));
        Assert.Equal("?::", rig.SendRaw("DL\r#A\r#A\r\\"));
        Assert.Equal(" 61\r\n:", rig.Ask("TC"));
    }

    [Fact]
    public async Task Download_while_a_program_runs_is_refused_with_code_17()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nWT 100\nJP#A").Do("XQ");

        Assert.Equal(17, rig.Refusal("DL"));
        Assert.Equal(19, rig.Refusal("XQ#A,0"));
        Assert.Equal(10, rig.Refusal("XQ#B,1"));
    }

    [Fact]
    public async Task DL_with_a_hash_appends_and_lists_show_it()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nEN");

        Assert.Equal("::", rig.SendRaw("DL#\r#B\rEN\\"));
        Assert.Equal("#A=0\r\n#B=2\r\n:", rig.Ask("LL"));
        Assert.Equal("2 #B\r\n3 EN\r\n:", rig.Ask("LS 2,3"));
        Assert.Equal("1 EN\r\n2 #B\r\n:", rig.Ask("LS 1,#B"));
        Assert.Equal(10, rig.Refusal("LS #NIX"));
        Assert.Equal(252, rig.Value("_DL"));
    }

    [Fact]
    public async Task Arrays_go_down_and_up()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DM lst[3]");

        Assert.Equal(":", rig.SendRaw("QD lst[]\r5.0,8.0,23.5\\"));
        Assert.Equal(" 5.0000, 8.0000, 23.5000\r\n\x1A:", rig.Ask("QU lst[],0,2,1"));
        Assert.Equal(" 8.0000\r\n 23.5000\r\n\x1A:", rig.Ask("QU lst[],1"));
        Assert.Equal(82, rig.Refusal("QU nix[]"));
        Assert.Equal(3, rig.Value("lst[-1]"));
        Assert.Equal(56, rig.Refusal("lst[3]=1"));
        Assert.Equal(56, rig.Refusal("MG lst[3]"));
        Assert.Equal("lst[3]\r\n:", rig.Ask("LA"));
    }

    [Fact]
    public async Task Data_record_has_its_layout()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DPA=-5", "SB3", "MOB");

        var record = Encoding.Latin1.GetBytes(rig.Ask("QR"));

        Assert.Equal(157, record.Length);
        Assert.Equal((byte)':', record[156]);
        Assert.Equal(new byte[] { 0x87, 0x0F, 156, 0 }, record[..4]);
        Assert.Equal((0xFF, 4), (record[6], record[16]));
        Assert.Equal(-5, BitConverter.ToInt32(record, 44 + 4));
        Assert.Equal(1, record[44 + 28] & 1);
    }

    [Fact]
    public async Task Data_record_shows_motion_direction_and_segment_count()
    {
        await using var rig = new SimulatorRig();
        rig.Do("VMAB", "VS 20000", "VP -1000,0", "VP -9000,0", "VE", "BGS").Pass(200);

        var record = Encoding.Latin1.GetBytes(rig.Ask("QR"));

        Assert.Equal(1, BitConverter.ToUInt16(record, 28));
        Assert.Equal(0x8020, BitConverter.ToUInt16(record, 30));
        Assert.Equal(0x8180, BitConverter.ToUInt16(record, 44));
        Assert.Equal(100, record[44 + 3]);
        Assert.Equal(-20000 * 64, BitConverter.ToInt32(record, 44 + 20));
    }

    [Fact]
    public async Task QR_takes_any_mask_of_blocks()
    {
        await using var rig = new SimulatorRig();

        var record = Encoding.Latin1.GetBytes(rig.Ask("QR BI"));

        Assert.Equal(4 + 24 + 28 + 1, record.Length);
        Assert.Equal(new byte[] { 0x84, 0x02, 56, 0 }, record[..4]);
    }

    [Fact]
    public async Task Messages_go_where_CF_says_and_carry_bit_7_under_CW_1()
    {
        await using var rig = new SimulatorRig();
        using var other = rig.Controller.OpenConnection();
        rig.Download("#A\nMG \"HI\"\nEN\n#B\nMG {EA}\"YOU\"\nEN").Do("XQ").Pass(10);
        Assert.Equal("", SimulatorRig.ReadAvailable(other));

        rig.Do("CFB", "CW 1", "XQ").Pass(10);

        Assert.Equal(string.Concat("HI\r\n".Select(c => (char)(c | 0x80))), SimulatorRig.ReadAvailable(other));
        Assert.Equal((66, 1), (rig.Value("_CF"), rig.Value("_CW")));
        Assert.Equal("::YOU\r\n", rig.SendRaw("CW 2;XQ#B\r") + SimulatorRig.ReadAvailable(rig.Pass(10).Stream));
    }

    [Fact]
    public async Task Queries_inside_a_program_print_as_messages()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nx=5;x=\nTPA\nEN").Do("CFI");

        Assert.Equal(": 5.0000\r\n 0\r\n", rig.Ask("XQ") + SimulatorRig.ReadAvailable(rig.Pass(10).Stream));
    }

    [Property]
    public Property Replies_do_not_depend_on_how_the_bytes_are_split()
    {
        const string session = "MG 1+2*3;x=5\r\nTP\r\n;;MG\"a;b\"\rDL\r#A\r\nx=x+1\rEN\r\\\rXQ#A\r\n\x12\x16\rbad;MG x\rQU\rUL\r";
        var bytes = Encoding.Latin1.GetBytes(session);
        var whole = ReplyTo(bytes, []);

        return Prop.ForAll(Gen.Choose(1, bytes.Length - 1).ToArrays(), cuts => ReplyTo(bytes, cuts) == whole);
    }

    private static string ReplyTo(byte[] bytes, int[] cuts)
    {
        var rig = new SimulatorRig();
        var reply = new StringBuilder();
        var start = 0;
        foreach (var cut in cuts.Append(bytes.Length).Order())
        {
            rig.Stream.Write(bytes.AsSpan(start, cut - start));
            reply.Append(SimulatorRig.ReadAvailable(rig.Stream));
            start = cut;
        }

        return reply.ToString();
    }
}
