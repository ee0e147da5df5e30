using System.Globalization;
using Engraver.Simulator.Language;
using Engraver.Simulator.Language.Commands;

namespace Engraver.Simulator.Tests.Fuzzing;

/// <summary>Generates lines as a client could send them: every command of the table, with one to eight axes, in every form of arguments, valid and
/// invalid.</summary>
internal sealed class StatementSource(Random random)
{
    private const string Letters = "ABCDEFGHNMSTXYZW*";
    private const string CommonLetters = "ABCD";

    private static readonly string[] Mnemonics = [.. CommandTable.Mnemonics.Concat(CommandTable.NotModelled).Where(m => m != "RS").Order(StringComparer.Ordinal)];
    private static readonly string[] OperandNames = [.. Operands.Names.Order(StringComparer.Ordinal)];
    private static readonly string[] Functions = ["ABS", "INT", "FRAC", "RND", "SQR", "COM", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "IN", "OUT", "AN", "FLOT", "REAL", "XYZ"];
    private static readonly string[] Names = ["a", "x", "go", "count", "px", "py", "TIME", "P1CH", "longname9", "speedA", "_TPA"];
    private static readonly string[] Labels = ["A", "B", "CMDERR", "LIMSWI", "ININT", "AUTO", "POSERR", "MCTIME", "TCPERR", "COMINT", "none"];
    private static readonly string[] Extremes =
    [
        "0", "-0", "1", "-1", "2147483647", "-2147483647", "-2147483648", "2147483648", "-2147483648.9999", "2147483647.9999", "99999999999999999999", "0.00001", "-0.00001",
        "$7FFFFFFF", "$80000000", "$FFFFFFFF.FFFF", "$", ".", "-", "--1", "8388607", "-8388608", "12000000", "67107840", "32767", "32768", "65536", "255", "256", "257", "4", "5", "8", "9",
    ];

    /// <summary>One to four statements.</summary>
    public string Line()
    {
        var count = Chance(4) ? random.Next(2, 5) : 1;
        return string.Join(';', Enumerable.Range(0, count).Select(_ => Statement()));
    }

    /// <summary>A program of generated lines, each at most as long as the memory accepts.</summary>
    public IEnumerable<string> Program()
    {
        foreach (var label in Labels.Where(_ => Chance(2)))
        {
            yield return "#" + label;
            for (var i = random.Next(1, 5); i > 0; i--) yield return Short(ProgramLine());
            yield return Pick("EN", "RE", "RI", "EN1,1,2", "JP#A", "JP#B,_TPA<5", "WT 20;JP#A", "");
        }
    }

    /// <summary>Commands before and during a motion, in an order that is often valid.</summary>
    public IEnumerable<string> Motion()
    {
        yield return Pick("", "", "MO", "SH", "CAS", "CAT", "MTA=2", "VT0.5", "ITA=0.1", "AB1", "ST", "RS");
        foreach (var statement in random.Next(6) switch { 0 => Sequence(Pick("LM", "LM", "CAT;LM", "CAS;LM"), Linear), 1 => Sequence("VM", Vector), 2 => Contour(), 3 => Cam(), 4 => Gear(), _ => Independent() }) yield return statement;
        yield return Pick("", "", "", "ST", "STS", "STT", "AB1", "CSS", "VR0", "VR1", "VR10,10", "BGS", "BGT", "BG");
    }

    public string Statement() => random.Next(40) switch
    {
        0 => "MG " + string.Join(Pick(",", " ", ""), Enumerable.Range(0, random.Next(1, 6)).Select(_ => MessageItem())),
        1 => Pick(Names) + "=" + Expression(),
        2 => Pick("px", "py", "none") + "[" + Expression() + "]=" + Expression(),
        3 => "~" + (char)random.Next('a', 'j') + "=" + Expression(),
        4 => Axes(Pick("LM", "VM", "CM", "EA", "BG", "SH", "MO", "ST", "AM", "HM", "FE", "FI", "AL", "TP")),
        5 => "IF(" + Expression() + ")",
        6 => Pick("JP", "JS", "XQ", "LS", "DL") + "#" + Pick(Labels) + (Chance(2) ? "," + Expression() : ""),
        7 => Pick("DM", "DA", "QU", "RA", "QD") + Pick("px[10]", "py[5]", "px[]", "py[],1,3,1", "*[]", "*", "px[],py[]", "none[]"),
        8 => Noise(random.Next(1, 12)),
        _ => Command(Pick(Mnemonics)),
    };

    private string ProgramLine() => Chance(3) ? string.Join(';', Motion()) : Line();

    private string Command(string mnemonic) => mnemonic + Pick("", "", " ") + (random.Next(9) switch
    {
        0 => "",
        1 => Axes(""),
        2 => "?",
        3 or 4 => Fields(),
        5 => Letter() + "=" + (Chance(4) ? Pick("?", "", "S", "T", "N", ">-2") : Expression()),
        6 => Fields() + "<" + Expression() + ">" + Expression(),
        7 => string.Join(',', Enumerable.Range(0, random.Next(1, 9)).Select(_ => Pick("?", "", "S", "A", Letter()))),
        _ => Expression(),
    });

    private IEnumerable<string> Sequence(string mode, Func<string> segment)
    {
        yield return Axes(mode);
        for (var i = random.Next(1, 8); i > 0; i--) yield return segment() + (Chance(3) ? "<" + Number() : "") + (Chance(3) ? ">" + Number() : "");
        if (!Chance(4)) yield return Pick("VE", "LE");
        yield return Pick("BGS", "BGT", "BGST", "BGSA");
        if (Chance(2)) yield return segment();
    }

    private string Linear() => Chance(3) ? "LI" + Letter() + "=" + Number() : "LI " + string.Join(',', Enumerable.Range(0, random.Next(1, 9)).Select(_ => Chance(3) ? "" : Near(2000)));

    private string Vector() => Chance(2) ? $"VP {Near(3000)},{Near(3000)}" : $"CR {Near(4000)},{Near(400)},{Near(800)}";

    private IEnumerable<string> Contour()
    {
        yield return Axes("CM");
        yield return "DT " + random.Next(-1, 10).ToString(CultureInfo.InvariantCulture);
        for (var i = random.Next(1, 5); i > 0; i--) yield return $"CD {Near(200)},{Near(200)}" + (Chance(3) ? "=" + Near(9) : "");
        if (Chance(2)) yield return Pick("CD 0=0", "DT0;CD0");
    }

    private IEnumerable<string> Cam()
    {
        yield return "EA" + Letter();
        yield return $"EM {Near(2000)},{Near(2000)},{Number()}";
        yield return $"EP {Near(300)},{Number()}";
        for (var i = random.Next(1, 5); i > 0; i--) yield return $"ET[{Near(260)}]={Near(500)},{Near(500)},{Number()},{Near(500)}";
        yield return "EB 1";
        yield return $"EG{Letter()}={Number()}";
        yield return $"JG{Letter()}={Near(30000)};BG{Letter()}";
        yield return $"EQ{Letter()}={Number()}";
    }

    private IEnumerable<string> Gear()
    {
        yield return $"GA{Letter()}={Pick("S", "T", "N", "A", "B", "CA")}";
        yield return $"GA ,{Letter()},S,{Letter()}";
        yield return $"GR {Near(130)},{Near(130)},{Number()}";
        yield return $"GM{Letter()}=1";
        yield return $"PR {Near(5000)},{Near(5000)};BG {Letter()}";
    }

    private IEnumerable<string> Independent()
    {
        yield return Pick("PR", "PA", "JG", "DP", "SP", "PT", "HM", "FI", "FE", "IP") + Letter() + "=" + Number();
        yield return Pick("PR", "PA", "JG", "IP", "DE", "FL", "BL") + " " + Fields();
        yield return Axes("BG");
        yield return Pick("IP", "JG", "PA", "AC", "DC", "OE", "ER") + Letter() + "=" + Number();
    }

    private string MessageItem() => random.Next(7) switch
    {
        0 => "\"" + Noise(random.Next(0, 20)).Replace("\"", "", StringComparison.Ordinal) + (Chance(8) ? "" : "\""),
        1 => "{" + Pick("N", "^7", "^", "^300", "EA", "EH", "P1", "P2", "S", "F", "Z9.9", "", "E") + "}",
        _ => Expression() + (Chance(2) ? "{" + Pick("F", "Z", "$", "S") + random.Next(0, 12).ToString(CultureInfo.InvariantCulture) + Pick("", ".", ".0", ".4", ".2", ".9") + "}" : ""),
    };

    private string Expression(int depth = 0) => random.Next(depth > 3 ? 4 : 9) switch
    {
        0 or 1 or 2 => Number(),
        3 => Operand(),
        4 => Number() + Pick("+", "-", "*", "/", "&", "|", "=", "<", ">", "<=", ">=", "<>", "%") + Expression(depth + 1),
        5 => "(" + Expression(depth + 1) + (Chance(9) ? "" : ")"),
        6 => "@" + Pick(Functions) + "[" + Expression(depth + 1) + (Chance(9) ? "" : "]"),
        7 => Pick(Names) + (Chance(3) ? "[" + Expression(depth + 1) + "]" : ""),
        _ => Pick("\"abc\"", "\"\"", "\"sevench\"", "\"x", "~a", "~z", "_", "@", "?", "", "TIME"),
    };

    private string Operand() => "_" + Pick(OperandNames) + Pick("", Letter(), random.Next(0, 10).ToString(CultureInfo.InvariantCulture), Letter() + "3", "~a");

    private string Number() => random.Next(4) switch { 0 => Pick(Extremes), 1 => Near(10), 2 => Near(5000), _ => (Near(3) + "." + random.Next(0, 99999).ToString(CultureInfo.InvariantCulture)) };

    private string Near(int largest) => random.Next(-largest, largest + 1).ToString(CultureInfo.InvariantCulture);

    private string Fields() => string.Join(',', Enumerable.Range(0, random.Next(1, 9)).Select(_ => Chance(4) ? "" : Chance(3) ? Expression() : Number()));

    private string Axes(string command) => command + Pick("", " ") + string.Concat(Enumerable.Range(0, random.Next(1, 9)).Select(_ => Letter()).Take(Chance(2) ? 1 : 8));

    private string Letter() => Chance(4) ? Letters[random.Next(Letters.Length)].ToString() : CommonLetters[random.Next(CommonLetters.Length)].ToString();

    private string Noise(int length) => string.Concat(Enumerable.Range(0, length).Select(_ => (char)random.Next(' ', 127)));

    private static string Short(string line) => line.Length > ProgramMemory.LongestLine ? line[..ProgramMemory.LongestLine] : line;

    private bool Chance(int oneIn) => random.Next(oneIn) == 0;

    private string Pick(params string[] choices) => choices[random.Next(choices.Length)];
}
