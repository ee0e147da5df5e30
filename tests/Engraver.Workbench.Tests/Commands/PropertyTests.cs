using Engraver.Core.Drawings;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Properties;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Tests.Commands.Reshaping;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>The properties of a line (A1, from 0,0 to 10,0), an arc (A2, 5,5, radius 4, 350 to 100 degrees), a circle (A3, 20,5, radius 3) and a square
/// (A4, 30,0, side 8), and CHPROP.</summary>
public class PropertyTests
{
    [Theory]
    [InlineData(0, "LINE A1 0 ByLayer StartX=0 StartY=0 EndX=10 EndY=0 DeltaX=10 DeltaY=0 Angle=0 Length=10 CLosed=No")]
    [InlineData(1, "ARC A2 0 ByLayer StartX=8.9392 StartY=4.3054 EndX=4.3054 EndY=8.9392 CenterX=5 CenterY=5 Radius=4 StartAngle=350 EndAngle=100 TotalAngle=110 Length=7.6794 Area=7.8414 CLosed=No")]
    [InlineData(2, "CIRCLE A3 0 ByLayer CenterX=20 CenterY=5 Radius=3 Diameter=6 CircumFerence=18.8496 Area=28.2743 CLosed=Yes")]
    [InlineData(3, "LWPOLYLINE A4 0 ByLayer Vertices=4 Length=32 Area=64 CLosed=Yes")]
    public async Task An_object_tells_what_a_person_asks(int entity, string expected)
    {
        await using var talk = CommandTestSession.WithDrawing();
        var values = ObjectProperties.Of(talk.State.Drawing!, [entity], DisplayPrecision.Initial);

        Assert.Equal(expected, string.Join(' ', values.Where(value => value.Property.Name != "SourceLine").Select((value, i) => i < 4 ? value.Value : $"{value.Property.Name}={value.Value}")));
        Assert.All(values, value => Assert.NotEmpty(value.Property.Title));
    }

    [Fact]
    public void Several_objects_tell_what_they_share_and_what_varies()
    {
        var red = new Layer("RED", On: true, Frozen: false, Plot: true);
        var drawing = new DrawingBuilder().Circle(0, 0, 5).Circle(9, 0, 5).OnLayer(red).Circle(9, 4, 5).Line(0, 0, 1, 1).Build();
        var circles = ObjectProperties.Of(drawing, [0, 1, 2], DisplayPrecision.Initial).ToDictionary(value => value.Property.Name, value => value.Value);
        Assert.Equal(("CIRCLE", "*VARIES*", "5", "*VARIES*", "*VARIES*"), (circles["Type"], circles["LAyer"], circles["Radius"], circles["CenterX"], circles["Handle"]));

        var mixed = ObjectProperties.Of(drawing, [0, 1, 3], DisplayPrecision.Initial).Select(value => value.Property.Name).ToList();
        Assert.DoesNotContain("Radius", mixed);
        Assert.Contains("Color", mixed);
    }

    /// <summary>One bent span would not be an ellipse, and a file cannot store it.</summary>
    [Fact]
    public async Task An_end_of_an_elliptical_arc_cannot_be_moved_by_itself()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("ELLIPSE", "A", "-10,0", "10,0", "5", "0", "180");
        var before = talk.State.Drawing!.Entities[0];
        var segments = talk.State.Drawing!.Parts.Count;
        var result = await talk.TypeAsync("CHPROP", "ALL", "", "StartX", "12");

        Assert.IsType<InputResult.Failed>(result);
        Assert.Equal((1, before, segments), (talk.State.Drawing!.Entities.Count, talk.State.Drawing!.Entities[0], talk.State.Drawing!.Parts.Count));
    }

    [Theory]
    [InlineData("A1", "StartY", "-3", 0, "0,-3 10,0")]
    [InlineData("A1", "EX", "12.5", 0, "0,0 12.5,0")]
    [InlineData("A3", "Radius", "4.5", 2, "24.5,5 24.5,5")]
    [InlineData("A3", "Diameter", "2", 2, "21,5 21,5")]
    [InlineData("A3", "CF", "6.283185307179586", 2, "21,5 21,5")]
    [InlineData("A3", "CenterX", "0", 2, "3,5 3,5")]
    [InlineData("A2", "StartAngle", "0", 1, "9,5 4.3054,8.9392")]
    [InlineData("A2", "EndAngle", "90", 1, "8.9392,4.3054 5,9")]
    public async Task A_number_is_changed_in_one_step(string handle, string property, string value, int entity, string ends)
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = Ends(talk, entity);
        await talk.TypeAsync("CHPROP", "H", handle, "", property, value);
        Assert.Equal(ends, Ends(talk, entity));
        await talk.TypeAsync("U");
        Assert.Equal(before, Ends(talk, entity));
    }

    /// <summary>Closing adds the line from the last vertex to the first, opening removes it.</summary>
    [Theory]
    [InlineData("PLINE|50,0|60,0|60,8|", "Closed", "Yes", "LwPolyline closed: 50,0>60,0 | 60,0>60,8 | 60,8>50,0")]
    [InlineData("PLINE|50,0|60,0|60,8|", "Closed", "y", "LwPolyline closed: 50,0>60,0 | 60,0>60,8 | 60,8>50,0")]
    [InlineData("PLINE|50,0|60,0|60,8|50,0|", "Closed", "Yes", "LwPolyline closed: 50,0>60,0 | 60,0>60,8 | 60,8>50,0")]
    [InlineData("PLINE|50,0|60,0|60,8|C", "Closed", "No", "LwPolyline: 50,0>60,0 | 60,0>60,8")]
    [InlineData("PLINE|50,0|60,0|60,8|C", "Closed", "Yes", "LwPolyline closed: 50,0>60,0 | 60,0>60,8 | 60,8>50,0")]
    public async Task A_polyline_is_closed_and_opened(string drawn, string property, string value, string expected)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync(drawn.Split('|'));
        var before = ObjectText.Of(talk.State.Drawing!, 4);
        await talk.TypeAsync("CHPROP", "L", "", property, value);

        Assert.Equal(expected, ObjectText.Of(talk.State.Drawing!, 4));
        Assert.Equal(expected.Contains("closed", StringComparison.Ordinal) ? "Yes" : "No", ObjectProperties.Of(talk.State.Drawing!, [4], DisplayPrecision.Initial).Single(one => one.Property.Name == "CLosed").Value);
        if (before == expected) return;
        await talk.TypeAsync("U");
        Assert.Equal(before, ObjectText.Of(talk.State.Drawing!, 4));
    }

    [Fact]
    public async Task Only_polylines_can_be_closed()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var drawing = talk.State.Drawing!;
        Assert.Equal([false, false, false, true], new[] { 0, 1, 2, 3 }.Select(index => ObjectProperties.Of(drawing, [index], DisplayPrecision.Initial).Single(one => one.Property.Name == "CLosed").IsEditable));
        Assert.False(ObjectProperties.Of(drawing, [3, 2], DisplayPrecision.Initial).Single(one => one.Property.Name == "CLosed").IsEditable);
    }

    [Fact]
    public async Task Layer_and_colour_of_several_objects_are_changed_and_the_selection_stays()
    {
        await using var talk = new CommandTestSession();
        var layer = new Layer("Cut Here", On: true, Frozen: false, Plot: true);
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 1, 0).Line(0, 1, 1, 1).OnLayer(layer).Line(0, 2, 1, 2).Build() });
        talk.Session.Document.Select([0, 1], []);
        await talk.TypeAsync("CHPROP", "LA", "cut here", "CHPROP", "C", "red");
        var entities = talk.State.Drawing!.Entities;
        Assert.Equal([(1, 1), (1, 1), (1, (int?)null)], new[] { 0, 1, 2 }.Select(index => (entities[index].Layer, entities[index].Colour.Index)));
        Assert.Equal([0, 1], talk.State.Selection);
        await talk.TypeAsync("CHPROP", "Color", "bylayer");
        Assert.True(talk.State.Drawing!.Entities[0].Colour.IsByLayer);
    }

    [Theory]
    [InlineData("A3", "Radius", "-1", "Radius cannot be -1")]
    [InlineData("A3", "Radius", "0", "Radius cannot be 0")]
    [InlineData("A3", "Radius", "wide", "'wide' is not a number")]
    [InlineData("A3", "Radius", "NaN", "'NaN' is not a number")]
    [InlineData("A3", "CenterX", "1e200", "leave the drawing range")]
    [InlineData("A1", "EX", "0", "nothing would remain of LINE A1")]
    [InlineData("A2", "EndAngle", "350", "End angle cannot be 350")]
    [InlineData("A1", "LAyer", "nowhere", "Layer nowhere does not exist")]
    [InlineData("A1", "Color", "mauve", "'mauve' is not a colour")]
    [InlineData("A4", "Closed", "maybe", "'maybe' is not valid. Nothing was changed. Enter Yes or No.")]
    public async Task A_wrong_value_is_told_and_nothing_changes(string handle, string property, string value, string told)
    {
        await using var talk = CommandTestSession.WithDrawing();
        var before = talk.State.Drawing;
        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CHPROP", "H", handle, "", property, value));

        Assert.Contains(told, failed.Message, StringComparison.Ordinal);
        Assert.Same(before, talk.State.Drawing);
    }

    private static string Ends(CommandTestSession talk, int entity)
    {
        var only = DrawingPick.Segments(talk.State.Drawing!, entity).Single();
        return $"{DisplayPrecision.Initial.FormatPoint(only.Start)} {DisplayPrecision.Initial.FormatPoint(only.End)}";
    }
}
