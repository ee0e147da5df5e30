namespace Engraver.Samples.Dxf;

/// <summary>Writes a document as a DXF file, section by section. It shares no code with the product's own reader and writer, which these files test.</summary>
internal sealed class DxfWriter
{
    /// <summary>Above every handle that is given out, whatever the number of entities: the entities are streamed after the header.</summary>
    private const string HandleSeed = "7FFFFFFF";

    private readonly TagStream tags;
    private readonly EntityWriter entities;

    private DxfWriter(ITagSink sink, DxfVersion version)
    {
        tags = new TagStream(sink, version);
        entities = new EntityWriter(tags);
    }

    public static void Write(DxfDocument document, ITagSink sink) => new DxfWriter(sink, document.Version).WriteAll(document);

    private void WriteAll(DxfDocument document)
    {
        DxfBlock[] blocks = tags.IsR12 ? [.. document.Blocks] : [new("*Model_Space", []), new("*Paper_Space", []), .. document.Blocks];
        (string Name, string Handle)[] records = [.. blocks.Select(block => (block.Name, tags.NextHandle()))];

        WriteHeader(document);
        new TableWriter(tags).Write(document, records);
        WriteBlocks(blocks, records);
        WriteSection("ENTITIES", () => WriteEntities(document.Entities, records.FirstOrDefault().Handle));
        if (!tags.IsR12)
        {
            WriteSection("OBJECTS", WriteRootDictionary);
        }

        tags.Text(0, "EOF");
    }

    private void WriteSection(string name, Action writeContent)
    {
        tags.Text(0, "SECTION").Text(2, name);
        writeContent();
        tags.Text(0, "ENDSEC");
    }

    private void WriteHeader(DxfDocument document) => WriteSection("HEADER", () =>
    {
        tags.Text(9, "$ACADVER").Text(1, VersionText(document.Version));
        if (!tags.IsR12)
        {
            tags.Text(9, "$DWGCODEPAGE").Text(3, "ANSI_1252").Text(9, "$HANDSEED").Text(5, HandleSeed);
            tags.Text(9, "$INSUNITS").Integer(70, (int)document.Unit);
            tags.Text(9, "$MEASUREMENT").Integer(70, document.Unit == DrawingUnit.Inches ? 0 : 1);
        }
    });

    private static string VersionText(DxfVersion version) => version switch
    {
        DxfVersion.R12 => "AC1009",
        DxfVersion.R2000 => "AC1015",
        _ => "AC1032",
    };

    private void WriteBlocks(DxfBlock[] blocks, (string Name, string Handle)[] records) => WriteSection("BLOCKS", () =>
    {
        for (var i = 0; i < blocks.Length; i++)
        {
            WriteBlock(blocks[i], records[i].Handle);
        }
    });

    private void WriteBlock(DxfBlock block, string record)
    {
        tags.Begin("BLOCK", record).Subclass("AcDbEntity").Text(8, "0").Subclass("AcDbBlockBegin")
            .Text(2, block.Name).Integer(70, 0).Point(10, default).Text(3, block.Name).Text(1, "");
        WriteEntities(block.Entities, record);
        tags.Begin("ENDBLK", record).Subclass("AcDbEntity").Text(8, "0").Subclass("AcDbBlockEnd");
    }

    private void WriteEntities(IEnumerable<DxfEntity> drawn, string? owner)
    {
        foreach (var entity in drawn)
        {
            entities.Write(entity, owner ?? "");
        }
    }

    private void WriteRootDictionary()
    {
        var (root, groups) = (tags.NextHandle(), tags.NextHandle());
        tags.Begin("DICTIONARY", "0", root).Subclass("AcDbDictionary").Integer(281, 1).Text(3, "ACAD_GROUP").Text(350, groups);
        tags.Begin("DICTIONARY", root, groups).Subclass("AcDbDictionary").Integer(281, 1);
    }
}
