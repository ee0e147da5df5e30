using System.Globalization;
using Engraver.Simulator.Values;
using FsCheck.Xunit;

namespace Engraver.Simulator.Tests;

/// <summary>galil-dmc.md E.</summary>
public class LanguageTests
{
    [Theory]
    [InlineData("1+2*3", " 9.0000")]
    [InlineData("10*30-60/30", " 8.0000")]
    [InlineData("1+(2*3)", " 7.0000")]
    [InlineData("0.6", " 0.6000")]
    [InlineData("2000/360", " 5.5555")]
    [InlineData("1234.5678", " 1234.5678")]
    [InlineData("@INT[-2.4]", "-2.0000")]
    [InlineData("@FRAC[-2.5]", "-0.5000")]
    [InlineData("@RND[5.5]", " 6.0000")]
    [InlineData("@RND[-5.5]", "-5.0000")]
    [InlineData("@RND[-5.7]", "-6.0000")]
    [InlineData("@ABS[-3]", " 3.0000")]
    [InlineData("@SQR[-16]", " 4.0000")]
    [InlineData("@COM[0]", "-1.0000")]
    [InlineData("@SIN[30]", " 0.5000")]
    [InlineData("@ATAN[1]", " 45.0000")]
    [InlineData("@FLOT[2.5]", " 1075838976.0000")]
    [InlineData("@FLOT[-1]{$8.0}", " $BF800000")]
    [InlineData("@REAL[$40200000]", " 2.5000")]
    [InlineData("@SIN[-32768]", "-0.1392")]
    [InlineData("$FF", " 255.0000")]
    [InlineData("$7FFFFFFF.FFFF", " 2147483647.9999")]
    [InlineData("-2147483648", "-2147483648.0000")]
    [InlineData("1=1", " 1.0000")]
    [InlineData("2<>2", " 0.0000")]
    [InlineData("(3>=2)&(1<2)", " 1.0000")]
    [InlineData("7&12", " 4.0000")]
    [InlineData("3|4", " 7.0000")]
    [InlineData("5,-6", " 5.0000 -6.0000")]
    public async Task Expressions_run_from_left_to_right_in_fixed_point(string expression, string printed)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(printed + "\r\n:", rig.Ask("MG " + expression));
    }

    [Theory]
    [InlineData("MG nix", 9)]
    [InlineData("MG 1/0", 4)]
    [InlineData("MG (1", 59)]
    [InlineData("MG \"abc", 52)]
    [InlineData("MG _QQ", 58)]
    [InlineData("MG @NIX[1]", 57)]
    [InlineData("MG @COS[32769]", 6)]
    [InlineData("MG @REAL[$7F800000]", 6)]
    [InlineData("MG {P2}\"x\"", 53)]
    [InlineData("MG _JS", 2)]
    [InlineData("LS 3,1", 6)]
    [InlineData("EW 1=5", 1)]
    [InlineData("MG 99999999999", 6)]
    [InlineData("toolongname=1", 9)]
    [InlineData("x=5%2", 4)]
    [InlineData("SP=5", 4)]
    [InlineData("VRS=1", 1)]
    [InlineData("VS 1", 6)]
    [InlineData("VA 1000", 6)]
    [InlineData("VR 11", 6)]
    [InlineData("SPA=12000002", 6)]
    [InlineData("OP 256", 6)]
    [InlineData("SB 9", 6)]
    [InlineData("CAA", 28)]
    [InlineData("DR 10", 133)]
    public async Task What_is_wrong_is_told_by_its_code(string command, int code)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(code, rig.Refusal(command));
    }

    [Property]
    public bool Integers_print_as_they_were_written(int n) =>
        NumberFormat.Variable.Print(FixedPoint.FromInteger(n)).TrimStart() == n.ToString(CultureInfo.InvariantCulture) + ".0000";

    [Property]
    public bool Sums_and_differences_undo_each_other_even_when_they_wrap(int a, int b) =>
        FixedPoint.FromInteger(a) + FixedPoint.FromInteger(b) - FixedPoint.FromInteger(b) == FixedPoint.FromInteger(a);

    [Fact]
    public async Task Nested_conditions_share_lines()
    {
        await using var rig = new SimulatorRig();
        const string program = """
            #A;n=0;i=0
            #LOOP
            IF (i=1);n=n+1;IF (1=2);n=n+100;ELSE;n=n+10;ENDIF;ELSE
            IF (i>3);n=n+1000
            ENDIF;ENDIF
            i=i+1;JP#LOOP,i<6
            EN
            """;

        rig.Run(program);

        Assert.Equal(2011, rig.Value("n"));
    }

    [Fact]
    public async Task A_missing_ENDIF_is_code_63()
    {
        await using var rig = new SimulatorRig();

        rig.Run("IF (1=2)\nx=1\nEN");

        Assert.Equal(" 63\r\n:", rig.Ask("TC"));
    }

    [Fact]
    public async Task Subroutines_go_16_deep()
    {
        await using var rig = new SimulatorRig();

        rig.Run("n=0\n#A\nn=n+1\nJS#A\nEN");

        Assert.Equal(17, rig.Value("n"));
        Assert.Equal(" 12\r\n:", rig.Ask("TC"));
    }

    [Fact]
    public async Task A_subroutine_gives_back_the_third_argument_of_its_EN()
    {
        await using var rig = new SimulatorRig();

        rig.Run("JS#HALF;a=_JS\nJS#NONE;b=_JS\nEN\n#HALF\nEN ,,7/2\n#NONE\nEN");

        Assert.Equal((3.5, 0), (rig.Value("a"), rig.Value("b")));
    }

    [Fact]
    public async Task TR_tells_every_line_before_it_runs()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\nx=1;x=2\nJS#B\nEN\n#B\nMG \"B\";EN").Do("CFI", "TR 1");

        var said = rig.Ask("XQ") + SimulatorRig.ReadAvailable(rig.RunToIdle().Stream);

        Assert.Equal(":1 x=1;x=2\r\n2 JS#B\r\n5 MG \"B\";EN\r\nB\r\n3 EN\r\n", said);
        Assert.Equal(" 1\r\n:", rig.Ask("TR ?"));
        Assert.Equal(":B\r\n", rig.Do("TR 0").Ask("XQ #B") + SimulatorRig.ReadAvailable(rig.RunToIdle().Stream));
    }

    [Fact]
    public async Task Without_CMDERR_an_error_stops_all_threads()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#BAD\nVP 1\nEN\n#LOOP\nWT 10\nJP#LOOP").Do("XQ#LOOP,3").Pass(30);
        Assert.Equal(8, rig.Value("_NO"));

        rig.Do("XQ#BAD,1").Pass(10);

        Assert.Equal((0, 1, 1), (rig.Value("_NO"), rig.Value("_ED0"), rig.Value("_ED1")));
    }

    [Fact]
    public async Task With_CMDERR_only_the_faulty_thread_stops_when_thread_0_runs()
    {
        await using var rig = new SimulatorRig();
        const string program = "#LOOP\nWT 10\nJP#LOOP\n#BAD\nVP 1\nEN\n#CMDERR\nc=_TC\nEN1";
        rig.Download(program).Do("XQ#LOOP,0", "XQ#LOOP,3").Pass(30).Do("XQ#BAD,1").Pass(10);

        Assert.Equal((9, 28), (rig.Value("_NO"), rig.Value("c")));
    }

    [Theory]
    [InlineData(true, 0)]
    [InlineData(false, 1)]
    public async Task Handlers_need_a_running_thread_0_when_the_switch_says_so(bool needed, int handled)
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { HandlersNeedThreadZero = needed });
        rig.Download("#BAD\nVP 1\nEN\n#CMDERR\nn=1\nEN").Do("n=0", "XQ#BAD,1").Pass(20);

        Assert.Equal((handled, 0), (rig.Value("n"), rig.Value("_NO")));
    }

    [Fact]
    public async Task An_error_inside_CMDERR_stops_everything()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { HandlersNeedThreadZero = false });
        rig.Download("#LOOP\nWT 10\nJP#LOOP\n#CMDERR\nn=n+1\nVP 1\nEN1\n#BAD\nVP 1").Do("n=0", "XQ#LOOP,0", "XQ#LOOP,3").Pass(20);

        rig.Do("XQ#BAD,1").Pass(50);

        Assert.Equal((1, 0), (rig.Value("n"), rig.Value("_NO")));
    }

    [Fact]
    public async Task Threads_take_turns_line_by_line_and_pay_for_every_command()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#A\na=a+1\nJP#A\n#B\nb=b+1;b=b+1;b=b+1;b=b+1;b=b+1\nJP#B").Do("a=0;b=0", "XQ#A,1", "XQ#B,2").Pass(1000);

        // In one round A runs 2 commands and B 6, 0.5 ms each: 4 ms.
        Assert.InRange(rig.Value("a"), 247, 254);
        Assert.InRange(rig.Value("b"), 1235, 1270);
    }

    [Fact]
    public async Task AT_keeps_a_period_whatever_the_loop_costs()
    {
        await using var rig = new SimulatorRig();
        rig.Download("n=0;AT0\n#A\nAT -20\nn=n+1\nJP#A").Do("XQ").Pass(1000);

        Assert.InRange(rig.Value("n"), 49, 51);
    }

    [Fact]
    public async Task Statements_of_the_field_are_understood()
    {
        await using var rig = new SimulatorRig();
        const string program = "#Hm_rdz;g_st=1\n  \tx = 5 ;' a note\nNO nothing\nMG {F4.0} x {N}\nEN ,,5\n'";

        rig.Do("CFI").Download(program).Do("XQ").Pass(10);

        Assert.Equal(" 0005", SimulatorRig.ReadAvailable(rig.Stream));
        Assert.Equal(1, rig.Value("g_st"));
    }

    [Fact]
    public async Task BP_and_RS_restore_the_burned_program_and_start_AUTO()
    {
        await using var rig = new SimulatorRig();
        rig.Download("#AUTO\nauto=7\nEN").Do("BP").Ask("RS");

        using var again = rig.Controller.OpenConnection();
        rig.Pass(10);

        Assert.Equal(" 7.0000\r\n:", SimulatorRig.Exchange(again, "MG auto\r"));
    }
}
