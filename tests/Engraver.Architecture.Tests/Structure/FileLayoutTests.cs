using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>The first lines of a test file. In the product the style rules of the SDK check them (.editorconfig); the tests are compiled without these rules,
/// which saves processor time.</summary>
public class FileLayoutTests
{
    private static readonly Lazy<IReadOnlyList<SourceFile>> s_files = new(() => SourceFile.Under("tests", ".cs"));

    [Fact]
    public void A_namespace_is_that_of_its_whole_file() => AssertNone(@"^namespace [\w.]+\s*\{");

    [Fact]
    public void Usings_stand_before_the_namespace() => AssertNone(@"^namespace [\w.]+;[\s\S]*^\s*using (static )?[A-Z][\w.]*( = [\w.<>, ]+)?;");

    [Fact]
    public void A_type_says_who_may_see_it() => AssertNone(@"^(sealed |static |abstract |partial |readonly )*(class|struct|record|interface|enum|delegate) \w");

    private static void AssertNone(string pattern)
    {
        var places = s_files.Value.SelectMany(file => Regex.Matches(CSharpText.Parse(file.Text).Code, pattern, RegexOptions.Multiline).Select(found => $"{file.Name}({file.LineOf(found.Index)})")).ToList();
        Assert.True(s_files.Value.Count > 500 && places.Count == 0, string.Join('\n', places));
    }
}
