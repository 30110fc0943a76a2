namespace UnityEditor;

public class ModelImporter : AssetImporter
{
    public bool isReadable { get; set; }
    public ModelImporterMeshCompression meshCompression { get; set; }
    public ModelImporterNormals importNormals { get; set; }
    public ModelImporterTangents importTangents { get; set; }
    public bool optimizeMeshVertices { get; set; }
    public bool optimizeMeshPolygons { get; set; }
    public bool weldVertices { get; set; }
    public float globalScale { get; set; }
}
