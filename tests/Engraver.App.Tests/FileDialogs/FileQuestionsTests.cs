using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.FileDialogs;
using Engraver.TestKit;

namespace Engraver.App.Tests.FileDialogs;

/// <summary>Which commands show the file dialog, and its questions before data is lost.</summary>
[Collection(DesktopCollection.Name)]
public sealed class FileQuestionsTests(DesktopFixture fixture) : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("dialog-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData("SAVEAS", "gasket.dxf")]
    [InlineData("EXPORT", "gasket.svg")]
    [InlineData("REPORT", "gasket.report.html")]
    [InlineData("PLOT Drawing", "gasket.svg")]
    [InlineData("POST galil", "gasket.dmc")]
    [InlineData("TABLE Drawn Csv", "gasket.csv")]
    [InlineData("AGIEPOST Exact", "gasket.agie")]
    public Task A_command_that_writes_offers_a_name_beside_the_drawing(string command, string name) => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter(command.Split(' '));
        Assert.True(Dialog(here).IsOpen);
        Assert.Equal((name, RepositoryFolder.Samples), (Dialog(here).Name, Dialog(here).Folder));
        here.Enter(Path.Combine(_folder.FullName, "out" + Path.GetExtension(name)));

        Assert.False(Dialog(here).IsOpen);
        Assert.True(File.Exists(Path.Combine(_folder.FullName, "out" + Path.GetExtension(name))), string.Join('\n', here.History));
    });

    [Fact]
    public Task Saving_adds_the_ending_and_the_title_follows() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("SAVEAS", Path.Combine(_folder.FullName, "my plate"));

        Assert.True(File.Exists(Path.Combine(_folder.FullName, "my plate.dxf")));
        Assert.Contains("my plate.dxf", here.Window.Title, StringComparison.Ordinal);
    });

    [Fact]
    public Task The_offered_place_is_that_of_the_drawing_whatever_dialog_was_open_before() => fixture.WithOperator(here =>
    {
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), Path.Combine(_folder.FullName, "plate.dxf"));
        here.Open("paper-001.dxf");
        here.Enter("SAVEAS", Path.Combine(Directory.CreateDirectory(Path.Combine(_folder.FullName, "other")).FullName, "x"));
        here.Open(Path.Combine(_folder.FullName, "plate.dxf"));
        here.Enter("SAVEAS");

        Assert.Equal(_folder.FullName, Dialog(here).Folder);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    [Theory]
    [InlineData("plate.dxf", ".svg", "plate.svg")]
    [InlineData("plate", ".svg", "plate.svg")]
    [InlineData("plate 1.5", ".svg", "plate 1.5.svg")]
    public void Another_kind_changes_the_ending_and_no_other_part_of_the_name(string name, string ending, string expected) =>
        Assert.Equal(expected, FileFilter.WithExtension(name, ending, [new FileFilter("", [".dxf"]), new FileFilter("", [".svg"])]));

    [Fact]
    public Task The_filter_decides_what_is_exported() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("EXPORT");
        here.Find<ComboBox>("FilterList").SelectedIndex = 1;
        here.WaitUntilIdle();
        Assert.Equal("gasket.csv", Dialog(here).Name);
        here.Enter(Path.Combine(_folder.FullName, "rows"));

        Assert.True(File.Exists(Path.Combine(_folder.FullName, "rows.csv")), string.Join('\n', here.History));
    });

    [Theory]
    [InlineData("", false)]
    [InlineData("No", false)]
    [InlineData("Yes", true)]
    public Task A_file_that_is_there_is_replaced_after_one_question(string answer, bool replaced) => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "out.dxf");
        File.WriteAllText(path, "old");
        here.Open("gasket.dxf");
        here.Enter("SAVEAS", path);
        Assert.True(here.Window.Model.Files.Question.IsOpen);
        Assert.Contains("out.dxf", here.Find<TextBlock>("QuestionText").Text, StringComparison.Ordinal);
        here.Enter(answer);

        Assert.Equal(replaced, File.ReadAllText(path) != "old");
        Assert.Equal(!replaced, Dialog(here).IsOpen); // another name can be typed
    });

    /// <summary>Typing the first letter of an answer highlights the answer that Enter accepts.</summary>
    [Fact]
    public Task The_letter_of_an_answer_marks_it_and_Enter_takes_it() => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "out.dxf");
        File.WriteAllText(path, "old");
        here.Open("gasket.dxf");
        here.Enter("SAVEAS", path);
        var answers = here.Find<ItemsControl>("AnswerList").GetVisualDescendants().OfType<Button>().ToList();
        Assert.Equal(["No"], Marked());
        foreach (var (letter, marked) in new[] { ("x", "No"), ("y", "Yes"), ("n", "No"), ("Y", "Yes"), ("e", "Yes"), ("q", "Yes") })
        {
            here.Hands.Type(letter);
            here.Step();
            Assert.Equal([marked], Marked());
        }

        here.Hands.Press(Key.Tab);
        Assert.Equal(["No"], Marked());
        here.Hands.Press(Key.Tab);
        Assert.Equal(["Yes"], Marked());
        Assert.Equal("old", File.ReadAllText(path));
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
        Assert.NotEqual("old", File.ReadAllText(path));

        IEnumerable<object?> Marked() => answers.Where(answer => answer.Classes.Contains("accent")).Select(answer => answer.Content);
    });

    [Fact]
    public Task Enter_alone_shows_the_result_where_no_name_stands() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        here.Enter("TABLE", "Drawn", "Csv");
        here.Click(here.Find<Button>("ShowButton"));
        here.WaitUntilIdle();

        Assert.False(Dialog(here).IsOpen);
        Assert.Null(here.Desk.Prompt.Command);
        Assert.True(here.History.Count() > 8);
    });

    [Fact]
    public Task Escape_leaves_dialog_and_command() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("SAVEAS");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();

        Assert.False(Dialog(here).IsOpen);
        Assert.Null(here.Desk.Prompt.Command);
        Assert.Contains("*Cancel*", here.History);
    });

    [Fact]
    public Task Without_FILEDIA_the_name_is_typed_at_the_command_line_and_may_stand_in_quotes() => fixture.WithOperator(here =>
    {
        here.Enter("FILEDIA", "0", "OPEN");
        Assert.False(Dialog(here).IsOpen);
        here.Enter($"\"{Path.Combine(RepositoryFolder.Samples, "gasket.dxf")}\"");

        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
    });

    [Fact]
    public Task A_script_and_pasted_lines_answer_by_themselves() => fixture.WithOperator(here =>
    {
        var opened = 0;
        Dialog(here).PropertyChanged += (_, _) => opened += Dialog(here).IsOpen ? 1 : 0;
        fixture.Desktop.ClipboardText = "open paper-001.dxf\nzoom e\n";
        here.Hands.Press(Key.V, Avalonia.Input.RawInputModifiers.Control);
        here.Until(() => here.Commands.Document.Current.Drawing is not null);
        here.WaitUntilIdle();

        Assert.Equal(0, opened);
    });

    [Fact]
    public Task A_menu_entry_shows_it_too() => fixture.WithOperator(here =>
    {
        here.Hands.Press(Key.O, RawInputModifiers.Control);
        here.WaitUntilIdle();

        Assert.True(Dialog(here).IsOpen);
    });

    [Fact]
    public Task What_is_typed_after_the_answer_is_for_the_command_line_at_once() => fixture.WithOperator(here =>
    {
        here.Enter("OPEN");
        here.Hands.Type("gasket");
        var asked = here.Desk.Prompt;
        here.Window.Model.Files.Dialog.Accept.Execute(null);
        here.Until(() => !Dialog(here).IsOpen || here.Desk.Prompt != asked);
        Assert.False(Dialog(here).IsOpen);
        here.Hands.Type("zoo");

        Assert.Equal("zoo", here.Window.Model.Command.Line);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    /// <summary>The command has not prompted yet: a space within a path is nevertheless a character of it.</summary>
    [Fact]
    public Task A_path_that_is_typed_at_once_keeps_its_spaces() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.WaitUntilIdle();
        here.Hands.Type("saveas ");
        var path = Path.Combine(_folder.FullName, "my second plate");
        here.Hands.Type(path);
        here.Enter("");

        Assert.Equal("my second plate.dxf", Path.GetFileName(here.Commands.Document.FilePath));
        Assert.Equal([path + ".dxf"], Directory.GetFiles(_folder.FullName));
    });

    [Fact]
    public Task What_was_typed_ahead_goes_into_the_name() => fixture.WithOperator(here =>
    {
        here.Hands.Type("open gask");
        here.WaitUntilIdle();
        here.Hands.Type("et");
        Assert.Equal("gasket", Dialog(here).Name);
        here.Enter("");

        Assert.Equal(70, here.Commands.Document.Current.Drawing?.Entities.Count);
    });

    [Theory]
    [InlineData("Cancel", false, false)]
    [InlineData("Open", true, false)]
    [InlineData("Save", true, true)]
    public Task Edits_that_are_in_no_file_are_asked_about_before_another_drawing_is_opened(string answer, bool opens, bool saves) => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "edited.dxf");
        File.Copy(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), path);
        here.Enter("OPEN", path, "ERASE", "ALL", "");
        var before = File.ReadAllText(path);
        here.Enter("OPEN", Path.Combine(RepositoryFolder.Samples, "paper-001.dxf"));
        Assert.True(here.Window.Model.Files.Question.IsOpen);
        here.Enter(answer);
        here.WaitUntilIdle();

        Assert.Equal(opens ? 4 : 0, here.Commands.Document.Current.Drawing!.Entities.Count);
        Assert.Equal(saves, File.ReadAllText(path) != before);
    });

    [Fact]
    public Task A_file_that_cannot_be_read_is_told_once() => fixture.WithOperator(here =>
    {
        var path = Path.Combine(_folder.FullName, "broken.dxf");
        File.WriteAllText(path, "this is no drawing\n");
        here.Enter("OPEN", path);

        Assert.Single(here.History, line => line.Contains("broken.dxf", StringComparison.Ordinal) && !line.StartsWith("Enter name", StringComparison.Ordinal));
        Assert.False(Dialog(here).IsOpen);
    });

    private static FileDialogModel Dialog(Operator here) => FileDialogTests.Dialog(here);
}
