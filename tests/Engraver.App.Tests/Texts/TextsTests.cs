using System.Text.RegularExpressions;
using System.Xml.Linq;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Texts;

public sealed class TextsTests
{
    private static readonly string s_app = Path.Combine(RepositoryFolder.Root, "src", "Engraver.App");
    private static readonly string[] s_readAloud = ["Text", "Content", "Header", "ToolTip.Tip", "PlaceholderText", "Title", "AutomationProperties.Name"];

    private static HashSet<string> Names => [.. XDocument.Load(Path.Combine(s_app, "Texts", "Texts.resx")).Root!.Elements("data").Select(data => data.Attribute("name")!.Value)];

    [Fact]
    public void No_window_holds_words_of_its_own()
    {
        var literal = from file in Directory.EnumerateFiles(s_app, "*.axaml", SearchOption.AllDirectories)
                      from element in XDocument.Load(file).Descendants()
                      from attribute in element.Attributes()
                      where s_readAloud.Contains(attribute.Name.LocalName) && !attribute.Value.StartsWith('{')
                      select $"{Path.GetFileName(file)}: {attribute}";

        Assert.Empty(literal);
        Assert.Empty(from file in Directory.EnumerateFiles(s_app, "*.axaml", SearchOption.AllDirectories)
                     from text in XDocument.Load(file).DescendantNodes().OfType<XText>()
                     where text.Parent!.Name.LocalName != "StreamGeometry" && text.Value.Trim().Length > 0
                     select $"{Path.GetFileName(file)}: {text.Value.Trim()}");
    }

    [Fact]
    public void Every_text_that_is_asked_for_is_there()
    {
        var names = Names;
        var asked = from file in Directory.EnumerateFiles(s_app, "*.*", SearchOption.AllDirectories)
                    where file.EndsWith(".axaml", StringComparison.Ordinal) || file.EndsWith(".cs", StringComparison.Ordinal)
                    from Match match in Regex.Matches(File.ReadAllText(file), """(?:\{t:Say |Text\.Get\(")([A-Za-z0-9.]+)(?:\}|"[,)])""")
                    select match.Groups[1].Value;

        Assert.DoesNotContain(asked, name => !names.Contains(name));
        Assert.True(asked.Count() > 80, "the scan found too few");
    }

    [Fact]
    public void Every_state_of_the_machine_and_every_alarm_state_has_a_word_and_a_shape()
    {
        var names = Names;
        var icons = File.ReadAllText(Path.Combine(s_app, "Theme", "Icons.axaml"));
        Assert.All(Enum.GetValues<Engraver.Workbench.Machines.MachineState>(), state =>
        {
            Assert.Equal(state.Token(), state.DisplayText());
            Assert.Contains($"\"Shape.{state}\"", icons, StringComparison.Ordinal);
        });
        Assert.All(Enum.GetNames<Engraver.Workbench.Machines.Alarms.AlarmState>(), state => Assert.Contains("AlarmState." + state, names));
        Assert.All(Enum.GetNames<Engraver.Core.Diagnostics.Severity>(), severity => Assert.Contains("Severity." + severity, names));
    }

    [Fact]
    public void A_text_with_figures_is_written_with_a_point() =>
        Assert.Equal("join 0.01 mm", Engraver.App.Texts.Text.Get("Status.Join", 0.01));

    [Theory]
    [InlineData(0, "0 errors")]
    [InlineData(1, "1 error")]
    [InlineData(2, "2 errors")]
    public void One_is_no_plural(int count, string expected) => Assert.Equal(expected, Engraver.App.Texts.Text.Count("Count.Error", count));

    [Fact]
    public void Every_noun_has_both_numbers()
    {
        var nouns = Names.Where(name => name.StartsWith("Count.", StringComparison.Ordinal)).Select(name => name[..name.LastIndexOf('.')]).Distinct().ToList();

        Assert.True(nouns.Count >= 5);
        Assert.All(nouns, noun => Assert.True(Names.Contains(noun + ".One") && Names.Contains(noun + ".Many"), noun));
    }

    [Theory]
    [InlineData(0, "00:00")]
    [InlineData(41.4, "00:41")]
    [InlineData(310, "05:10")]
    [InlineData(9000, "2:30:00")]
    [InlineData(-1, "00:00")]
    public void Durations_read_like_a_clock(double seconds, string expected) => Assert.Equal(expected, Engraver.App.Texts.ClockText.Format(seconds));
}
