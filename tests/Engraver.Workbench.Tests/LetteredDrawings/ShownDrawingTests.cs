using Engraver.Core.Drawings;
using Engraver.TestKit;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.LetteredDrawings;

public class ShownDrawingTests
{
    [Fact]
    public void A_drawing_without_texts_is_itself()
    {
        var drawing = new DrawingBuilder().Line(0.0, 0.0, 1.0, 1.0).Build();
        Assert.Same(drawing, ShownDrawing.Of(drawing));
    }

    /// <summary>After each edit the letters are those that a new computation gives.</summary>
    [Fact]
    public async Task After_an_edit_only_changed_letters_are_computed()
    {
        await using var talk = new CommandTestSession();
        (int, object)[] entities = [(0, "LINE"), (5, "A1"), (8, "0"), (10, 0.0), (20, 0.0), (11, 40.0), (21, 0.0), .. Text("A2", 0.0, "S"), .. Text("A3", 20.0, "L"), .. Text("A4", 40.0, "R")];
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), new DxfText().Header("AC1015", 4).Section("ENTITIES", entities).End().ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf");
        foreach (var edit in (string[][])[["MOVE", "H", "A3", "", "0,0", "5,7"], ["ERASE", "H", "A2", ""], ["LINE", "0,0", "9,9", "4,0", ""], ["COPY", "H", "A4", "", "0,0", "7,7", ""], ["TEXT", "1,1", "2", "0", "new", ""], ["U"]])
        {
            var before = ShownDrawing.Of(talk.State.Drawing!);
            await talk.TypeAsync(edit);
            var drawing = talk.State.Drawing!;
            Assert.NotSame(before, ShownDrawing.Of(drawing));
            Assert.Equal(Letters(ShownDrawing.Of(drawing with { FileName = "other" })), Letters(ShownDrawing.Of(drawing)));
        }
    }

    private static (int, object)[] Text(string handle, double x, string content) => [(0, "TEXT"), (5, handle), (8, "0"), (10, x), (20, 5.0), (40, 5.0), (1, content)];

    private static IEnumerable<(int, double, double)> Letters(Drawing shown) =>
        [.. Enumerable.Range(0, shown.Entities.Count).SelectMany(entity => DrawingPick.Segments(shown, entity).Select(part => (entity, part.Start.X, part.End.Y)))];
}
