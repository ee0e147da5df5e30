using Avalonia.Platform.Storage;
using Engraver.App.Shell;

namespace Engraver.App.Tests.Shell;

[Collection(DesktopCollection.Name)]
public sealed class FileQuestionsTests(DesktopFixture fixture)
{
    [Theory]
    [InlineData("SAVEAS", "out.dxf", "*.dxf")]
    [InlineData("EXPORT", "out.svg", "*.svg")]
    public Task A_clicked_command_that_writes_asks_by_a_dialog(string command, string name, string type) => fixture.WithOperator(here =>
    {
        var folder = Directory.CreateTempSubdirectory("desktop-files-");
        var (dialogs, person) = AnsweringDialogs.Make();
        person.Chosen = Path.Combine(folder.FullName, name);
        here.Open("gasket.dxf");
        Run(here, dialogs, command);

        Assert.True(File.Exists(person.Chosen), string.Join('\n', here.History));
        var asked = Assert.IsType<FilePickerSaveOptions>(person.Asked);
        Assert.Equal((type, "gasket"), (asked.FileTypeChoices![0].Patterns![0], asked.SuggestedFileName));
        folder.Delete(recursive: true);
    });

    [Fact]
    public Task A_clicked_command_that_reads_asks_by_a_dialog() => fixture.WithOperator(here =>
    {
        var (dialogs, person) = AnsweringDialogs.Make();
        person.Chosen = Path.Combine(TestKit.RepositoryFolder.Samples, "gasket.dxf");
        Run(here, dialogs, "OPEN");

        Assert.Equal(70, here.Commands.Document.Current.Drawing!.Entities.Count);
    });

    [Fact]
    public Task A_dialog_that_is_left_ends_the_command() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        Run(here, AnsweringDialogs.Make().Dialogs, "SAVEAS");

        Assert.Null(here.Desk.Prompt.Command);
        Assert.Contains("*Cancel*", here.History);
    });

    [Fact]
    public Task Without_FILEDIA_the_name_is_typed() => fixture.WithOperator(here =>
    {
        var (dialogs, person) = AnsweringDialogs.Make();
        here.Open("gasket.dxf");
        here.Enter("FILEDIA", "0");
        Run(here, dialogs, "SAVEAS");

        Assert.Equal("SAVEAS", here.Desk.Prompt.Command);
        Assert.Null(person.Asked);
    });

    private static void Run(Operator here, IStorageProvider dialogs, string command)
    {
        var run = new FileQuestions(here.Desk, () => dialogs).RunAsync(command);
        here.Until(() => run.IsCompleted);
        here.Rest();
    }
}
