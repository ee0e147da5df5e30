using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Settings;

public sealed class OperationsSourceTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void A_template_is_found_by_its_name_and_a_file_first()
    {
        File.WriteAllText(PathOf("engrave.operations.json"), Text("template"));
        Assert.Equal("template", OperationsSource.Load(PathOf("engrave")).Operations[0].Id);

        File.WriteAllText(PathOf("engrave"), Text("file"));
        Assert.Equal("file", OperationsSource.Load(PathOf("engrave")).Operations[0].Id);
        Assert.Contains(PathOf("other"), Assert.Throws<SettingException>(() => OperationsSource.Load(PathOf("other"))).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("air, coolant", "air coolant")]
    [InlineData("5", "5")]
    [InlineData("[\"air\", \"6\"]", "air 6")]
    public void Outputs_are_typed_as_a_list(string typed, string outputs)
    {
        File.WriteAllText(PathOf("a.json"), Text("o1"));

        Assert.Equal(outputs, string.Join(' ', OperationEdits.Changed(OperationsSource.Load(PathOf("a.json")), "o1", "outputs", typed).Operations[0].Outputs));
    }

    private string PathOf(string name) => Path.Combine(_folder.FullName, name);

    private static string Text(string id) => $$"""{ "version": "1.0", "tools": [{"number": 1, "diameter": 1}], "operations": [{ "id": "{{id}}", "kind": "engrave", "select": "rest", "tool": 1 }] }""";
}
